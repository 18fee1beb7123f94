// Rigid shapes. Part of fmc_contact.hpp.
#ifndef FMC_CONTACT_SHAPES_HPP
#define FMC_CONTACT_SHAPES_HPP

#include "callbacks.hpp"
#include "data.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <vector>

namespace fmc {

struct Part;

namespace detail {

// Data to which a shape of the C interface points.
struct ShapeArrays {
  std::deque<fmc_shape> shapes;
  std::deque<std::vector<fmc_part>> parts;
  Distances distances;
};

}  // namespace detail

// A rigid shape in its own frame, of a kind of `fmc_shape_kind`, where its measures stand: made by the functions below, for
// `Context::add_obstacle` and for parts of a compound. Arrays are not owned, and read when the obstacle is added.
class Shape {
 public:
  static Shape half_space() { return Shape(FMC_SHAPE_HALF_SPACE); }
  static Shape ball(double radius) { return Shape(FMC_SHAPE_BALL, radius); }
  static Shape cylinder(double radius, double half_height) { return Shape(FMC_SHAPE_CYLINDER, radius, half_height); }
  static Shape cone(double radius, double half_height) { return Shape(FMC_SHAPE_CONE, radius, half_height); }
  static Shape capsule(double radius, double half_height) { return Shape(FMC_SHAPE_CAPSULE, radius, half_height); }
  static Shape cuboid(View<const double> half_extents) {
    Shape shape(FMC_SHAPE_CUBOID);
    shape.half_extents_ = half_extents;
    return shape;
  }
  static Shape polytope(Coords points, View<const int32_t> facets) {
    Shape shape(FMC_SHAPE_POLYTOPE);
    shape.points_ = points, shape.narrow_ = facets;
    return shape;
  }
  static Shape polytope(Coords points, View<const int64_t> facets) {
    Shape shape(FMC_SHAPE_POLYTOPE);
    shape.points_ = points, shape.wide_ = facets;
    shape.fields_.index_size = 8;
    return shape;
  }
  static Shape convex_hull(Coords points) {
    Shape shape(FMC_SHAPE_CONVEX_HULL);
    shape.points_ = points;
    return shape;
  }
  // `counts` and `lengths` of the dim - 1 axes of the grid, whose last one runs fastest in `heights`.
  static Shape height_field(View<const std::size_t> counts, View<const double> lengths, View<const double> heights,
                            double thickness) {
    Shape shape(FMC_SHAPE_HEIGHT_FIELD);
    shape.counts_ = counts, shape.lengths_ = lengths, shape.heights_ = heights;
    shape.fields_.thickness = thickness;
    return shape;
  }
  static Shape compound(View<const Part> parts);
  // A body given by its signed distance in its own frame; see `SignedDistance`. The call that evaluates it rethrows its
  // exception, and changes nothing.
  static Shape signed_distance(SignedDistance distance) {
    Shape shape(FMC_SHAPE_SIGNED_DISTANCE);
    shape.one_ = std::move(distance);
    return shape;
  }
  // The same for many points at once.
  static Shape signed_distances(SignedDistances distances) {
    Shape shape(FMC_SHAPE_SIGNED_DISTANCE);
    shape.many_ = std::move(distances);
    return shape;
  }

  // As the C interface takes it. It points into `arrays`, whose distances must live as long as the obstacle.
  const fmc_shape &as_c(int dim, detail::ShapeArrays &arrays, detail::Callbacks *callbacks) const;

 private:
  explicit Shape(fmc_shape_kind kind, double radius = 0, double half_height = 0) {
    check(fmc_shape_init(&fields_, kind));
    fields_.radius = radius, fields_.half_height = half_height;
  }
  static void need(std::size_t size, std::size_t wanted, const char *what) {
    if (size != wanted)
      detail::refuse(FMC_ERROR_LENGTH,
                     std::string(what) + ": " + std::to_string(size) + " entries, not " + std::to_string(wanted));
  }

  fmc_shape fields_{};
  Coords points_;
  View<const double> half_extents_, lengths_, heights_;
  View<const std::size_t> counts_;
  View<const int32_t> narrow_;
  View<const int64_t> wide_;
  std::shared_ptr<const std::vector<Part>> parts_;
  SignedDistance one_;
  SignedDistances many_;
};

// A part of a compound: a shape, with its pose in the frame of the compound.
struct Part {
  Shape shape;
  Pose pose = {};
};

inline Shape Shape::compound(View<const Part> parts) {
  Shape shape(FMC_SHAPE_COMPOUND);
  shape.parts_ = std::make_shared<std::vector<Part>>(parts.begin(), parts.end());
  return shape;
}

inline const fmc_shape &Shape::as_c(int dim, detail::ShapeArrays &arrays, detail::Callbacks *callbacks) const {
  const auto axes = static_cast<std::size_t>(dim);
  fmc_shape fields = fields_;
  if (fields.kind == FMC_SHAPE_CUBOID) {
    need(half_extents_.size(), axes, "half_extents");
    std::copy(half_extents_.begin(), half_extents_.end(), fields.half_extents);
  }
  if (fields.kind == FMC_SHAPE_POLYTOPE || fields.kind == FMC_SHAPE_CONVEX_HULL) fields.points = points_.as_c(dim);
  if (fields.kind == FMC_SHAPE_POLYTOPE) {
    const bool is_wide = fields.index_size == 8;
    fields.facets = is_wide ? static_cast<const void *>(wide_.data()) : narrow_.data();
    fields.facet_count = is_wide ? detail::rows_of(wide_, axes, "facets") : detail::rows_of(narrow_, axes, "facets");
  }
  if (fields.kind == FMC_SHAPE_HEIGHT_FIELD) {
    need(counts_.size(), axes - 1, "counts"), need(lengths_.size(), axes - 1, "lengths");
    std::size_t points = 1;
    for (const auto count : counts_) {
      if (count != 0 && points > heights_.size() / count) points = heights_.size() + 1;  // too many, and no overflow
      else points *= count;
    }
    need(heights_.size(), points, "heights");
    fields.heights = heights_.data();
    std::copy(counts_.begin(), counts_.end(), fields.counts);
    std::copy(lengths_.begin(), lengths_.end(), fields.lengths);
  }
  if (parts_) {
    std::vector<fmc_part> list;
    for (const Part &part : *parts_) list.push_back({&part.shape.as_c(dim, arrays, callbacks), part.pose});
    arrays.parts.push_back(std::move(list));
    fields.parts = arrays.parts.back().data(), fields.part_count = parts_->size();
  }
  if (fields.kind == FMC_SHAPE_SIGNED_DISTANCE) {
    auto call = std::make_unique<detail::DistanceCall>(detail::DistanceCall{one_, many_, axes, callbacks});
    fields.signed_distance = detail::DistanceCall::run, fields.user = call.get();
    arrays.distances.push_back(std::move(call));
  }
  arrays.shapes.push_back(fields);
  return arrays.shapes.back();
}

// `add_obstacle` of a context by the name of the shape. Returns the index, which an obstacle keeps when others are removed.
template <class Context>
class AddsShapes {
 public:
  std::size_t add_half_space(const Pose &pose = {}) { return add(Shape::half_space(), pose); }
  std::size_t add_ball(double radius, const Pose &pose = {}) { return add(Shape::ball(radius), pose); }
  std::size_t add_cylinder(double radius, double half_height, const Pose &pose = {}) {
    return add(Shape::cylinder(radius, half_height), pose);
  }
  std::size_t add_cone(double radius, double half_height, const Pose &pose = {}) {
    return add(Shape::cone(radius, half_height), pose);
  }
  std::size_t add_capsule(double radius, double half_height, const Pose &pose = {}) {
    return add(Shape::capsule(radius, half_height), pose);
  }
  std::size_t add_cuboid(View<const double> half_extents, const Pose &pose = {}) {
    return add(Shape::cuboid(half_extents), pose);
  }
  std::size_t add_polytope(Coords points, View<const int32_t> facets, const Pose &pose = {}) {
    return add(Shape::polytope(points, facets), pose);
  }
  std::size_t add_polytope(Coords points, View<const int64_t> facets, const Pose &pose = {}) {
    return add(Shape::polytope(points, facets), pose);
  }
  std::size_t add_convex_hull(Coords points, const Pose &pose = {}) { return add(Shape::convex_hull(points), pose); }
  std::size_t add_height_field(View<const std::size_t> counts, View<const double> lengths, View<const double> heights,
                               double thickness, const Pose &pose = {}) {
    return add(Shape::height_field(counts, lengths, heights, thickness), pose);
  }
  std::size_t add_compound(View<const Part> parts, const Pose &pose = {}) { return add(Shape::compound(parts), pose); }
  std::size_t add_signed_distance(SignedDistance distance, const Pose &pose = {}) {
    return add(Shape::signed_distance(std::move(distance)), pose);
  }
  std::size_t add_signed_distances(SignedDistances distances, const Pose &pose = {}) {
    return add(Shape::signed_distances(std::move(distances)), pose);
  }

 private:
  std::size_t add(const Shape &shape, const Pose &pose) { return static_cast<Context *>(this)->add_obstacle(shape, pose); }
};

}  // namespace fmc

#endif  // FMC_CONTACT_SHAPES_HPP
