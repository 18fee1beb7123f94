// Of FEBio 4, what the plugin uses of its DumpStream.h. Like FEBio's, it leaves a list as it is where an empty one was saved.
#pragma once
#include <vector>

class DumpStream {
 public:
  bool IsSaving() const { return m_bsave; }
  void Open(bool bsave) { m_bsave = bsave, m_at = 0; }
  DumpStream &operator&(std::vector<double> &o) {
    if (m_bsave) {
      m_data.push_back(static_cast<double>(o.size()));
      m_data.insert(m_data.end(), o.begin(), o.end());
      return *this;
    }
    const auto count = static_cast<std::size_t>(m_data[m_at++]);
    if (count > 0) o.assign(m_data.begin() + static_cast<std::ptrdiff_t>(m_at), m_data.begin() + static_cast<std::ptrdiff_t>(m_at + count));
    m_at += count;
    return *this;
  }

 private:
  bool m_bsave = true;
  std::size_t m_at = 0;
  std::vector<double> m_data;
};
