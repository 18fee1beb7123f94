// What the programs that test the wrapper count with.
#ifndef EXPECT_HPP
#define EXPECT_HPP

#include <fmc_contact.hpp>

#include <cstdio>

inline int failures = 0;

#define EXPECT(...)                                          \
  do {                                                       \
    const bool good_ = (__VA_ARGS__);                        \
    if (!good_) {                                            \
      ++failures;                                            \
      std::printf("FAIL line %d: %s\n", __LINE__, #__VA_ARGS__); \
    }                                                        \
  } while (0)

// Whether a call fails with this status, and with a text that holds these words.
template <class Call>
bool refused(fmc_status status, const std::string &words, Call &&call) {
  try {
    call();
  } catch (const fmc::Error &error) {
    const std::string text = error.what();
    const bool good = error.status() == status && error.status_class() == fmc_status_class(status) &&
                      text.find(error.name()) == 0 && text.find(words) != std::string::npos;
    if (!good) std::printf("%s\n", error.what());
    return good;
  }
  return false;
}

inline int report() {
  std::printf("%d failures\n", failures);
  return failures != 0;
}

#endif
