// Functions of the host that throw: what they throw comes out of the call that called them, and the context goes on.
//
//   c++ -std=c++17 callbacks.cpp $(pkg-config --cflags --libs fmc_contact)
#include "expect.hpp"

#include <cmath>

namespace {

struct Tired {
  int calls;
};

const std::vector<double> square = {0, 0, 1, 0, 1, 1, 0, 1};
const std::vector<int32_t> quad = {0, 1, 2, 3};

// Whether a call throws just this object.
template <class Call>
bool tired(int calls, Call &&call) {
  try {
    call();
  } catch (const Tired &thrown) {
    return thrown.calls == calls;
  }
  return false;
}

}  // namespace

int main() try {
  fmc::Options options(1000);
  options.law = FMC_LAW_VOLUME;
  options.spacing = 0.01;

  // 1. A disc of radius 2 by its signed distance, point by point and all at once, and as a ball: one volume, one force.
  const double radius = 2;
  const auto pose = fmc::Pose::at({0.5, 0.05 - radius});
  const auto disc = [radius](fmc::View<const double> x, fmc::View<double> gradient) {
    const double r = std::hypot(x[0], x[1]);
    gradient[0] = x[0] / r, gradient[1] = x[1] / r;
    return r - radius;
  };
  fmc::Context ball(2, square, {{FMC_QUAD4, quad}}, options), one(2, square, {{FMC_QUAD4, quad}}, options);
  fmc::Context many(2, square, {{FMC_QUAD4, quad}}, options);
  ball.add_ball(radius, pose);
  one.add_signed_distance(disc, pose);
  many.add_signed_distances(
      [&](fmc::View<const double> x, fmc::View<double> distances, fmc::View<double> gradients) {
        EXPECT(x.size() == 2 * distances.size() && gradients.size() == x.size());
        for (std::size_t i = 0; i < distances.size(); ++i)
          distances[i] = disc({&x[2 * i], 2}, {&gradients[2 * i], 2});
      },
      pose);
  std::vector<double> forces(8), other(8);
  const fmc_result exact = ball.evaluate(square, forces), pointwise = one.evaluate(square, forces);
  const fmc_result batch = many.evaluate(square, other);
  EXPECT(forces == other && pointwise.volume == batch.volume);
  EXPECT(std::fabs(pointwise.volume - exact.volume) < 1e-6 * exact.volume);
  EXPECT(std::fabs(one.body(0).force[1] + one.obstacle(0).force[1]) < 1e-9 && one.body(0).force[1] > 0);

  // 2. It throws at its third call; then it does not, and the results are those of before.
  int calls = 0, limit = 3;
  fmc::Context context(2, square, {{FMC_QUAD4, quad}}, options);
  const auto obstacle = context.add_signed_distance(
      [&](auto x, auto gradient) {
        if (++calls == limit) throw Tired{calls};
        return disc(x, gradient);
      },
      pose);
  other.assign(8, 7);
  EXPECT(tired(3, [&] { context.evaluate(square, other); }));
  EXPECT(other == std::vector<double>(8, 7) && context.pairs().empty());
  limit = 0;
  fmc::Context gone = std::move(context);
  gone.evaluate(square, other);
  EXPECT(other == forces);
  const auto throws = [&](auto call) {
    calls = 0, limit = 1;
    const bool good = tired(1, call);
    limit = 0;
    return good;
  };
  EXPECT(throws([&] { gone.evaluate(square); }));
  EXPECT(throws([&] { gone.nodal_contact(square); }));
  EXPECT(gone.obstacle(0).force[1] == one.obstacle(0).force[1]);

  // 3. An exception of the wrapper's own kind is not changed either; nor may the context be used from within.
  const auto nested = gone.add_signed_distance(
      [&](auto, auto) -> double {
        gone.evaluate(square);
        return 0;
      },
      pose);
  EXPECT(refused(FMC_ERROR_BUSY, "", [&] { gone.evaluate(square); }));
  gone.remove_obstacle(nested);
  gone.remove_obstacle(obstacle);
  EXPECT(refused(FMC_ERROR_OBSTACLE_REMOVED, "", [&] { gone.remove_obstacle(obstacle); }));
  EXPECT(gone.evaluate(square).pair_count == 0);

  // 4. A distance that is not a number is the library's own error.
  const auto vague = gone.add_signed_distance([](auto, auto) { return std::nan(""); }, pose);
  EXPECT(refused(FMC_ERROR_SIGNED_DISTANCE, "", [&] { gone.evaluate(square); }));
  gone.remove_obstacle(vague);

  // 5. Messages: a ball that is swallowed by the square. The log may ask, throw, be replaced, and be taken away.
  gone.add_ball(0.1, fmc::Pose::at({0.5, 0.5}));
  std::vector<std::string> heard;
  gone.set_log([&](int32_t level, const char *text) {
    EXPECT(level == FMC_LOG_WARNING);
    heard.push_back(text);
    EXPECT(gone.warnings().size() == 1);
  });
  EXPECT(gone.evaluate(square).warning_count == 1);
  EXPECT(heard.size() == 1 && gone.warning(0).text == heard[0] && gone.warning(0).code == FMC_WARNING_SWALLOWED_BODY);
  gone.set_log([](int32_t, const char *text) { throw std::runtime_error(text); });
  std::string caught;
  try {
    gone.evaluate(square, other);
  } catch (const std::runtime_error &error) {
    caught = error.what();
  }
  EXPECT(caught == heard[0] && heard.size() == 1 && other == std::vector<double>(8));
  gone.set_log({});
  EXPECT(gone.evaluate(square).warning_count == 1 && heard.size() == 1);

  // 6. A call that takes long is ended, on one thread and on three; the context is as it was.
  for (const int32_t threads : {1, 3}) {
    auto fine = options;
    fine.law = FMC_LAW_VOLUME;
    fine.estimator = FMC_ESTIMATOR_FIBERS;
    fine.spacing = 2e-7;
    fine.threads = static_cast<decltype(fine.threads)>(threads);
    std::vector<double> two = square;
    for (std::size_t k = 0; k < square.size(); ++k) two.push_back(square[k] + 0.5);
    std::vector<int64_t> both = {0, 1, 2, 3, 4, 5, 6, 7}, ids = {0, 1};
    fmc::Context slow(2, two, {{FMC_QUAD4, both}}, fine, ids);
    int asked = 0;
    slow.set_interrupt([&] { return ++asked > 2; });
    EXPECT(refused(FMC_ERROR_INTERRUPTED, "ended by its caller", [&] { slow.evaluate(two); }));
    EXPECT(asked == 3);
    slow.set_interrupt([]() -> bool { throw std::runtime_error("enough"); });
    std::string said;
    try {
      slow.evaluate(two);
    } catch (const std::runtime_error &error) {
      said = error.what();
    }
    EXPECT(said == "enough");
    slow.set_interrupt({});
    fine.spacing = 0.01;
    slow.set_options(fine);
    EXPECT(std::abs(slow.evaluate(two).volume - 0.25) < 2.5e-3);
  }

  // 7. Functions end with their obstacle, when they are replaced, where they were refused, and with the context.
  const auto held = std::make_shared<int>(0);
  {
    fmc::Context last(2, square, {{FMC_QUAD4, quad}}, options);
    const auto distance = [held](auto, auto) { return 1.0 + *held; };
    const auto logged = [held](int32_t, const char *) { ++*held; };
    const auto copies = held.use_count();
    for (int turn = 0; turn < 100; ++turn) last.remove_obstacle(last.add_signed_distance(distance));
    EXPECT(held.use_count() == copies);
    auto broken = pose;
    broken.scale = -1;
    EXPECT(refused(FMC_ERROR_BAD_POSE, "", [&] { last.add_signed_distance(distance, broken); }));
    EXPECT(held.use_count() == copies);
    for (int turn = 0; turn < 100; ++turn) last.set_log(logged);
    last.add_signed_distance(distance);
    EXPECT(held.use_count() == copies + 2);
    last = fmc::Context(2, square, {{FMC_QUAD4, quad}}, options);
    EXPECT(held.use_count() == copies);
    last.set_log(logged);
  }
  EXPECT(held.use_count() == 1);

  // 8. A law of an interface that throws: the exception comes out of every call that asks it, and the context goes on.
  {
    std::vector<double> two = square;
    for (std::size_t k = 0; k < square.size(); ++k) two.push_back(square[k] + (k % 2 == 0 ? 1 : 0));
    std::vector<int32_t> both = {0, 1, 2, 3, 4, 5, 6, 7}, ids = {0, 1};
    fmc::Context bonded(2, two, {{FMC_QUAD4, both}}, options, ids);
    fmc::PairOptions own;
    own.interface_kind = FMC_INTERFACE_LAW;
    const auto copies = held.use_count();
    int calls = 0;
    bool is_tired = false;
    const auto law = [&calls, &is_tired, held](const fmc::LawPoints &points, const fmc::LawResponse &response) {
      if (++calls, is_tired) throw Tired{calls};
      for (std::size_t i = 0; i < points.jump.size(); ++i) response.traction[i] = points.jump[i];
      for (std::size_t i = 0; i < response.tangent.size(); ++i) response.tangent[i] = i % 4 == 0 || i % 4 == 3 ? 1 : 0;
    };
    bonded.set_law_pair(0, 1, own, law);
    bonded.set_law_pair(1, 0, own, law);
    EXPECT(held.use_count() == copies + 2);
    for (std::size_t k = 8; k < 16; k += 2) two[k] += 0.1;
    EXPECT(std::abs(bonded.evaluate(two).energy) == 0 && std::abs(bonded.body(1).force[0] + 0.1) < 1e-15);
    is_tired = true, calls = 0;
    EXPECT(tired(1, [&] { bonded.evaluate(two); }) && tired(2, [&] { bonded.law_points(two); }));
    EXPECT(tired(3, [&] { fmc::check_law(law, 0, 2, 0.1); }));
    is_tired = false;
    bonded.evaluate(two);
    EXPECT(std::abs(bonded.body(1).force[0] + 0.1) < 1e-15);
  }
  EXPECT(held.use_count() == 1);
  return report();
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
