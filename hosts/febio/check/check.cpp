// Loads the plugin as FEBio does, and solves two blocks on a floor with it: signs, the matrix, history, what is refused, and every force
// beside the library's C functions.
//
//   check libfmc_febio.so
#include "springs.h"

#include <FECore/DumpStream.h>
#include <FECore/FEException.h>

#include <expect.hpp>

#include <dlfcn.h>

namespace {

constexpr double stiffness = 2e6, friction = 0.3;

// The same contact by the functions of C, at the nodes of the model.
class Direct {
 public:
  explicit Direct(Springs &host) : host_(host) {
    const std::vector<double> x = places(&FENode::m_r0);
    std::vector<int32_t> conn;
    for (const FEElement &element : host.domain.m_Elem) conn.insert(conn.end(), element.m_node.begin(), element.m_node.end());
    const fmc_cell_block cells = {FMC_HEX8, sizeof(int32_t), conn.data(), conn.size() / 8};
    const fmc_coords coords = {x.data(), x.size() / 3, 3, 1};
    fmc_options options;
    fmc_options_init(&options);
    options.stiffness = stiffness, options.friction_coefficient = friction;
    EXPECT(fmc_context_new_from_cells(3, &coords, &cells, 1, nullptr, &options, &context_) == FMC_OK);
    fmc_shape floor;
    fmc_pose pose;
    EXPECT(fmc_shape_init(&floor, FMC_SHAPE_HALF_SPACE) == FMC_OK && fmc_pose_init(&pose) == FMC_OK);
    // The outward normal of the shape is its last axis, z.
    EXPECT(fmc_context_add_obstacle(context_, &floor, &pose, nullptr) == FMC_OK);
  }
  ~Direct() { fmc_context_free(&context_); }
  Direct(const Direct &) = delete;
  Direct &operator=(const Direct &) = delete;

  void begin(vec3d FENode::*place) { at(place, fmc_context_begin_step); }
  void commit() { at(&FENode::m_rt, fmc_context_commit_step); }
  // Forces by equation and, with the other sign, at what is prescribed, as FEBio has them.
  std::vector<double> forces(std::vector<double> &reactions) {
    const std::vector<double> x = places(&FENode::m_rt);
    std::vector<double> f(x.size());
    const fmc_coords coords = {x.data(), x.size() / 3, 3, 1};
    const fmc_forces to = {f.data(), f.size() / 3, 3, 1};
    EXPECT(fmc_context_evaluate(context_, &coords, &to, 0, nullptr) == FMC_OK);
    std::vector<double> R(static_cast<std::size_t>(host_.equation_count));
    reactions.assign(static_cast<std::size_t>(host_.prescribed_count), 0);
    for (std::size_t k = 0; k < f.size(); ++k) {
      const int id = host_.model.m_mesh.m_Node[k / 3].m_ID[k % 3];
      if (id >= 0) R[static_cast<std::size_t>(id)] += f[k];
      if (id < -1) reactions[static_cast<std::size_t>(-id - 2)] -= f[k];
    }
    return R;
  }
  // Force of others and the floor on a body.
  fmc_resultant on(std::size_t body) {
    fmc_resultant found{};
    EXPECT(fmc_context_body_resultant(context_, body, &found) == FMC_OK);
    return found;
  }

 private:
  std::vector<double> places(vec3d FENode::*place) {
    std::vector<double> x;
    for (FENode &node : host_.model.m_mesh.m_Node) x.insert(x.end(), {(node.*place).x, (node.*place).y, (node.*place).z});
    return x;
  }
  void at(vec3d FENode::*place, fmc_status (*call)(fmc_context *, const fmc_coords *)) {
    const std::vector<double> x = places(place);
    const fmc_coords coords = {x.data(), x.size() / 3, 3, 1};
    EXPECT(call(context_, &coords) == FMC_OK);
  }
  Springs &host_;
  fmc_context *context_ = nullptr;
};

double largest(const std::vector<double> &a) {
  double found = 0;
  for (const double v : a) found = std::fmax(found, std::fabs(v));
  return found;
}
double apart(std::vector<double> a, const std::vector<double> &b) {
  EXPECT(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
  return largest(a) / largest(b);
}

// A block of 8 cubes that stands on the floor, and a single cube upon it, whose nodes lie between those of the block.
void build(Springs &host) {
  host.add_block(2, 1.0, {0, 0, 0});
  host.add_block(1, 0.57, {0.21, 0.17, 1.0});
  host.number(1.57);
}

std::unique_ptr<FENLConstraint> made(FECoreKernel &kernel, Springs &host, double mu, double tolerance = 0) {
  auto *contact = dynamic_cast<FENLConstraint *>(kernel.Create(FENLCONSTRAINT_ID, "fmc contact", &host.model));
  EXPECT(contact != nullptr);
  EXPECT(!contact->Validate());  // A stiffness has to be given.
  contact->SetParameter("stiffness", stiffness);
  contact->SetParameter("friction", mu);
  contact->SetParameter("penetration", tolerance);
  contact->SetParameter("floor_normal", vec3d(0, 0, 1));
  contact->Activate();
  EXPECT(contact->Validate() && contact->Init());
  return std::unique_ptr<FENLConstraint>(contact);
}

// Two steps with friction, the second sideways, then the beginning of a third. FEBio's residual is what pushes the nodes.
void history(FECoreKernel &kernel) {
  Springs host;
  build(host);
  const auto contact = made(kernel, host, friction);
  Direct direct(host);
  std::vector<double> reactions, others;
  const auto is_direct = [&] {
    const auto forces = host.residual(*contact, reactions, false), expected = direct.forces(others);
    return apart(forces, expected) < 1e-14 && (largest(others) == 0 || apart(reactions, others) < 1e-14);
  };

  direct.begin(&FENode::m_r0);
  EXPECT(host.solve(*contact, vec3d(0, 0, -0.01), false) > 0);
  EXPECT(is_direct());
  // The upper block is pushed up by what the lower one is pushed down by, and the floor bears it.
  host.residual(*contact, reactions);
  double push = 0;
  for (std::size_t k = 2; k < reactions.size(); k += 3) push += reactions[k];
  const double upper = direct.on(1).force[2];
  EXPECT(upper > 100 && std::fabs(direct.on(0).force[2]) < 1e-9 * upper);
  EXPECT(std::fabs(push + upper) < 1e-9 * upper);
  EXPECT(host.model.m_log.find("fmc contact: force") == std::string::npos);
  host.model.DoCallback(CB_MAJOR_ITERS);
  EXPECT(host.model.m_log.find("fmc contact: force") != std::string::npos);
  direct.commit();

  EXPECT(host.solve(*contact, vec3d(1e-4, 0, 0), false) > 0);
  EXPECT(is_direct());
  const double sideways = direct.on(1).force[0];
  EXPECT(sideways < -1 && sideways > -friction * upper);
  const auto pushed = host.residual(*contact, reactions, false);

  // Not accepted yet: a step that would begin here knows nothing of it, and one that begins where it began ends as it did.
  const auto nodes = host.model.m_mesh.m_Node;
  const auto begin_here = [&] {
    for (FENode &node : host.model.m_mesh.m_Node) node.m_rp = node.m_rt;
    contact->PrepStep();
  };
  begin_here();
  EXPECT(apart(host.residual(*contact, reactions, false), pushed) > 1e-3);
  host.model.m_mesh.m_Node = nodes;
  contact->PrepStep();
  EXPECT(apart(host.residual(*contact, reactions, false), pushed) < 1e-14);

  // Accepted: in the next step the block is held as it was.
  host.model.DoCallback(CB_MAJOR_ITERS);
  direct.commit();
  begin_here();
  EXPECT(apart(host.residual(*contact, reactions, false), pushed) < 1e-12);
  EXPECT(is_direct());
}

// A step that FEBio gives up and tries again, and a restart: both from the state that a stream has kept.
void streams(FECoreKernel &kernel) {
  Springs host;
  build(host);
  const auto contact = made(kernel, host, friction, 1e-5);
  std::vector<double> reactions;
  EXPECT(host.solve(*contact, vec3d(0, 0, -0.01), false) > 0);
  host.model.DoCallback(CB_MAJOR_ITERS);
  EXPECT(host.solve(*contact, vec3d(1e-4, 0, 0), false) > 0);
  host.model.DoCallback(CB_MAJOR_ITERS);
  const auto forces = host.residual(*contact, reactions, false);

  DumpStream kept;
  contact->Serialize(kept);
  const auto nodes = host.model.m_mesh.m_Node;
  EXPECT(host.solve(*contact, vec3d(0, 0, -0.01), false) > 0);
  EXPECT(apart(host.residual(*contact, reactions, false), forces) > 0.1);
  host.model.m_mesh.m_Node = nodes;
  kept.Open(false);
  contact->Serialize(kept);
  for (FENode &node : host.model.m_mesh.m_Node) node.m_rp = node.m_rt;
  contact->PrepStep();
  EXPECT(apart(host.residual(*contact, reactions, false), forces) < 1e-12);

  // FEBio makes the constraint of a restart without Init().
  auto *fresh = dynamic_cast<FENLConstraint *>(kernel.Create(FENLCONSTRAINT_ID, "fmc contact", &host.model));
  const std::unique_ptr<FENLConstraint> again(fresh);
  again->SetParameter("stiffness", stiffness), again->SetParameter("friction", friction), again->SetParameter("penetration", 1e-5);
  again->SetParameter("floor_normal", vec3d(0, 0, 1));
  kept.Open(false);
  again->Serialize(kept);
  again->PrepStep();
  EXPECT(apart(host.residual(*again, reactions, false), forces) < 1e-12);
}

// K = -dR/du, with entries that FEBio has room for, at a state that is pressed and pushed sideways.
void derivative(FECoreKernel &kernel, double mu) {
  Springs host;
  build(host);
  const auto contact = made(kernel, host, mu);
  EXPECT(host.solve(*contact, vec3d(2e-2, 1e-2, -0.013), false) > 0);
  const LinearSystem system = host.stiffness(*contact, false, false);
  EXPECT(system.complete && !system.entries.empty());
  FEGlobalMatrix profile;
  contact->BuildMatrixProfile(profile);
  double scale = 0, wrong = 0, unsymmetric = 0;
  for (const auto &[place, value] : system.entries) {
    if (place.first == -1 || place.second == -1) continue;
    const auto at = [](int id) { return id < -1 ? -id - 2 : id; };
    EXPECT(profile.m_pattern.count({at(place.first), at(place.second)}) == 1);
    scale = std::fmax(scale, std::fabs(value));
    const auto across = system.entries.find({place.second, place.first});
    unsymmetric = std::fmax(unsymmetric, std::fabs(value - (across == system.entries.end() ? 0 : across->second)));
  }
  const double step = 1e-6;
  const std::vector<double *> x = host.unknowns();
  for (std::size_t j = 0; j < x.size(); ++j) {
    std::vector<double> reactions, sides[2];
    for (const int side : {0, 1}) {
      const double kept = *x[j];
      *x[j] += side == 0 ? -step : step;
      sides[side] = host.residual(*contact, reactions, false);
      *x[j] = kept;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto entry = system.entries.find({static_cast<int>(i), static_cast<int>(j)});
      const double exact = entry == system.entries.end() ? 0 : entry->second;
      wrong = std::fmax(wrong, std::fabs(exact + (sides[1][i] - sides[0][i]) / (2 * step)));
    }
  }
  // Without friction the tangent is the derivative, and differences have the rounding of forces by the step. With friction it neglects what is
  // of the order of twice the penetration by the size of facets (docs/friction.md), here 0.002 by 0.5.
  EXPECT(wrong < (mu > 0 ? 8e-3 : 1e-7) * scale);
  EXPECT(mu > 0 ? unsymmetric > 1e-3 * scale : unsymmetric < 1e-12 * scale);
  // A solver with half a matrix is given one that is symmetric.
  const LinearSystem half = host.stiffness(*contact, true, false);
  for (const auto &[place, value] : half.entries) EXPECT(std::fabs(value - half.entries.at({place.second, place.first})) < 1e-12 * scale);
}

// Multipliers: as little penetration as is asked for, told in the log.
void penetration(FECoreKernel &kernel) {
  double forces[2];
  for (const int is_limited : {0, 1}) {
    Springs host;
    build(host);
    const auto contact = made(kernel, host, 0, is_limited ? 1e-5 : 0);
    EXPECT(host.solve(*contact, vec3d(0, 0, -0.01), true) > 0);
    std::vector<double> reactions;
    host.residual(*contact, reactions);
    forces[is_limited] = 0;
    for (std::size_t k = 2; k < reactions.size(); k += 3) forces[is_limited] -= reactions[k];
    EXPECT((host.model.m_log.find("multipliers") != std::string::npos) == (is_limited == 1));
  }
  // Penetration is compliance.
  EXPECT(forces[1] > 1.001 * forces[0]);
}

void refusals(FECoreKernel &kernel) {
  Springs host;
  build(host);
  const auto contact = made(kernel, host, 0);
  // A cell that is inverted: FEBio is to try the step again.
  host.model.m_mesh.m_Node[13].m_rt.z += 0.8;
  std::vector<double> reactions;
  bool is_tried_again = false;
  try {
    host.residual(*contact, reactions);
  } catch (const NANInResidualDetected &) {
    is_tried_again = true;
  }
  EXPECT(is_tried_again && host.model.m_errors.find("FMC_ERROR_INVERTED_CELL") != std::string::npos);
  host.model.m_mesh.m_Node[13].m_rt.z -= 0.8;
  // After a reset, everything is as at first.
  const auto at_first = host.residual(*contact, reactions);
  contact->Reset();
  EXPECT(host.residual(*contact, reactions) == at_first);
  // Elements of other shapes are told by number; those that are no solids have no contact.
  host.domain.m_Elem.emplace_back(77, FE_ELEM_SHELL, ET_QUAD4, std::vector<int>{0, 1, 2, 3});
  contact->Reset();
  EXPECT(contact->Init());
  host.domain.m_Elem.emplace_back(78, FE_ELEM_SOLID, ET_HEX27, std::vector<int>(27));
  contact->Reset();
  EXPECT(!contact->Init() && host.model.m_errors.find("element 78") != std::string::npos);
}

}  // namespace

int main(int argc, char **argv) try {
  void *plugin = argc > 1 ? dlopen(argv[1], RTLD_NOW) : nullptr;
  if (plugin == nullptr) return std::fprintf(stderr, "%s\n", argc > 1 ? dlerror() : "check libfmc_febio.so"), 1;
  const auto version = reinterpret_cast<unsigned int (*)()>(dlsym(plugin, "GetSDKVersion"));
  const auto initialize = reinterpret_cast<void (*)(FECoreKernel &)>(dlsym(plugin, "PluginInitialize"));
  EXPECT(version != nullptr && version() == FE_SDK_VERSION && initialize != nullptr);
  FECoreKernel kernel;
  initialize(kernel);
  EXPECT(kernel.Create(FENLCONSTRAINT_ID, "other", nullptr) == nullptr);
  derivative(kernel, 0);
  derivative(kernel, friction);
  history(kernel);
  streams(kernel);
  penetration(kernel);
  refusals(kernel);
  return report();
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
