// Contact by fmc_contact in FEBio 4: a plugin with the constraint "fmc contact", for all solid elements of a model and a rigid floor.
//
//   c++ -std=c++17 -O2 -fPIC -shared fmc_febio.cpp -o libfmc_febio.so -I$FEBIO_SDK/include -L$FEBIO_SDK/lib -lfecore
//     $(pkg-config --cflags --libs fmc_contact)
//
// FEBio solves R(u) = 0, where R is the sum of all forces on the nodes, by K du = R with K = -dR/du: the library's forces and tangent as
// they are. README.md has the parameters, and what was tested.
#include <FECore/DumpStream.h>
#include <FECore/FECoreKernel.h>
#include <FECore/FEDomain.h>
#include <FECore/FEException.h>
#include <FECore/FELinearSystem.h>
#include <FECore/FEMesh.h>
#include <FECore/FEModel.h>
#include <FECore/FENLConstraint.h>
#include <FECore/log.h>

#include <fmc_contact.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace {

// Shapes whose nodes have one order in FEBio and in the library.
const std::map<int, fmc_cell_type> types = {{ET_TET4, FMC_TET4},     {ET_HEX8, FMC_HEX8},       {ET_PENTA6, FMC_WEDGE6},
                                            {ET_PYRA5, FMC_PYRAMID5}, {ET_TET10, FMC_TET10},     {ET_HEX20, FMC_HEX20},
                                            {ET_PENTA15, FMC_WEDGE15}, {ET_PYRA13, FMC_PYRAMID13}};

// As many updates of multipliers as the library's own search makes at most.
constexpr int most_augmentations = 12;

class FmcContact : public FENLConstraint {
 public:
  explicit FmcContact(FEModel *model) : FENLConstraint(model) {}

  bool Init() override {
    if (!FENLConstraint::Init()) return false;
    try {
      contact();
    } catch (const fmc::Error &error) {
      feLogError("fmc contact: %s\n", error.what());
      return false;
    }
    return true;
  }

  // Friction counts slip from here; a step that FEBio tries again begins here again.
  void PrepStep() override {
    guarded([&] { contact().begin_step(places(&FENode::m_rp)); });
  }

  void LoadVector(FEGlobalVector &R, const FETimeInfo &) override {
    const std::vector<double> x = places(&FENode::m_rt);
    std::vector<double> forces(x.size());
    guarded([&] { contact().evaluate(x, forces); });
    for (int node = 0; node < GetMesh().Nodes(); ++node) {
      const double *force = &forces[3 * static_cast<std::size_t>(node)];
      if (force[0] == 0 && force[1] == 0 && force[2] == 0) continue;
      std::vector<int> nodes = {node}, equations = equations_of(nodes);
      std::vector<double> on_node(force, force + 3);
      R.Assemble(nodes, equations, on_node);
    }
  }

  // FEBio asks for it before every new matrix, and for the matrix at the same place.
  void BuildMatrixProfile(FEGlobalMatrix &M) override {
    each_pair(tangent(0), [&](const std::vector<int> &nodes, const Blocks &) {
      std::vector<int> equations = equations_of(nodes);
      M.build_add(equations);
    });
  }

  void StiffnessMatrix(FELinearSystem &LS, const FETimeInfo &) override {
    each_pair(tangent(LS.IsSymmetric() ? FMC_TANGENT_SYMMETRIC : 0), [&](const std::vector<int> &nodes, const Blocks &blocks) {
      const int size = 3 * static_cast<int>(nodes.size());
      FEElementMatrix ke(size, size);
      ke.zero();
      for (const auto &[row, col, block] : blocks)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) ke[3 * row + i][3 * col + j] = block[3 * i + j];
      ke.SetNodes(nodes);
      ke.SetIndices(equations_of(nodes));
      LS.Assemble(ke);
    });
  }

  // True ends the step: nothing penetrates by more than the tolerance, or none is given.
  bool Augment(int augmentation, const FETimeInfo &) override {
    if (tolerance_ <= 0) return true;
    fmc_augmentation found{};
    guarded([&] { found = contact().augment(places(&FENode::m_rt), tolerance_); });
    feLog(" fmc contact: penetration %lg, %d multipliers\n", found.penetration, static_cast<int>(found.multiplier_count));
    return found.is_converged != 0 || augmentation + 1 >= most_augmentations;
  }

  void Reset() override { contact_.reset(); }

  // FEBio keeps the state before each step by this, and goes back to it if the step fails; restarts use it too.
  void Serialize(DumpStream &ar) override {
    FENLConstraint::Serialize(ar);
    std::vector<double> slip, shifts;  // A stream leaves an empty list as it is.
    guarded([&] {
      if (ar.IsSaving()) {
        slip = contact().slip();
        for (const fmc_multiplier &m : contact().multipliers())
          shifts.insert(shifts.end(), {static_cast<double>(m.node), static_cast<double>(m.body), static_cast<double>(m.partner_kind),
                                       static_cast<double>(m.partner), m.shift, m.towards[0], m.towards[1], m.towards[2]});
      }
      ar & slip & shifts;
      if (ar.IsSaving()) return;
      std::vector<fmc_multiplier> multipliers;
      for (std::size_t k = 0; k + 8 <= shifts.size(); k += 8) {
        const double *row = &shifts[k];
        fmc_multiplier m{};
        m.struct_size = sizeof m;
        m.node = static_cast<int64_t>(row[0]), m.body = static_cast<std::size_t>(row[1]);
        m.partner_kind = static_cast<int32_t>(row[2]), m.partner = static_cast<std::size_t>(row[3]);
        m.shift = row[4], std::copy(row + 5, row + 8, m.towards);
        multipliers.push_back(m);
      }
      contact().set_slip(slip);
      contact().set_multipliers(multipliers);
    });
  }

 private:
  // Blocks of 3 x 3 with their places, 0 or 1, among one or two nodes.
  struct Block {
    int row, col;
    const double *values;
  };
  using Blocks = std::vector<Block>;

  // Made when it is first asked for: FEBio does not initialise what it reads from a restart file.
  fmc::Context &contact() {
    if (contact_) return *contact_;
    std::map<fmc_cell_type, std::vector<int32_t>> cells;
    for (int d = 0; d < GetMesh().Domains(); ++d) {
      FEDomain &domain = GetMesh().Domain(d);
      for (int e = 0; e < domain.Elements(); ++e) {
        const FEElement &element = domain.ElementRef(e);
        if (element.Class() != FE_ELEM_SOLID) continue;
        const auto type = types.find(element.Shape());
        if (type == types.end())
          throw fmc::Error(FMC_ERROR_UNKNOWN_CELL_TYPE, "element " + std::to_string(element.GetID()) + " has the shape " +
                                                            std::to_string(element.Shape()) + " of FEBio, which is not supported");
        std::vector<int32_t> &list = cells[type->second];
        list.insert(list.end(), element.m_node.begin(), element.m_node.end());
      }
    }
    std::vector<fmc::Cells<int32_t>> blocks;
    for (const auto &[type, list] : cells) blocks.push_back({type, list});
    fmc::Options options(stiffness_);
    options.friction_coefficient = friction_;
    const std::vector<double> undeformed = places(&FENode::m_r0);
    auto made = std::make_unique<fmc::Context>(3, undeformed, blocks, options);
    if (normal_.x != 0 || normal_.y != 0 || normal_.z != 0)
      made->add_half_space(fmc::Pose::along({point_.x, point_.y, point_.z}, {normal_.x, normal_.y, normal_.z}));
    made->begin_step(undeformed);
    dofs_ = {GetDOFIndex("x"), GetDOFIndex("y"), GetDOFIndex("z")};
    if (!is_called_) GetFEModel()->AddCallback(end_of_step, CB_MAJOR_ITERS, this);
    is_called_ = true;
    contact_ = std::move(made);
    return *contact_;
  }

  // A step has converged.
  static bool end_of_step(FEModel *, unsigned int, void *self) {
    static_cast<FmcContact *>(self)->commit();
    return true;
  }
  void commit() {
    if (!IsActive()) return;
    guarded([&] {
      const std::vector<double> x = places(&FENode::m_rt);
      contact().evaluate(x);
      for (const fmc_resultant &body : contact().bodies())
        feLog(" fmc contact: force %lg %lg %lg on body %d\n", body.force[0], body.force[1], body.force[2], static_cast<int>(body.id));
      contact().commit_step(x);
    });
  }

  std::vector<double> places(vec3d FENode::*place) {
    std::vector<double> x;
    x.reserve(3 * static_cast<std::size_t>(GetMesh().Nodes()));
    for (int node = 0; node < GetMesh().Nodes(); ++node) {
      const vec3d &r = GetMesh().Node(node).*place;
      x.insert(x.end(), {r.x, r.y, r.z});
    }
    return x;
  }

  std::vector<int> equations_of(const std::vector<int> &nodes) {
    std::vector<int> equations;
    for (const int node : nodes)
      for (const int dof : dofs_) equations.push_back(GetMesh().Node(node).m_ID[static_cast<std::size_t>(dof)]);
    return equations;
  }

  fmc::Csr<int32_t> tangent(uint32_t flags) {
    fmc::Csr<int32_t> found;
    guarded([&] { found = contact().tangent(places(&FENode::m_rt), flags | FMC_CSR_BLOCKS); });
    return found;
  }

  // Nodes alone and pairs of nodes that the tangent couples, each once: the "elements" that FEBio assembles.
  template <class Visit>
  static void each_pair(const fmc::Csr<int32_t> &tangent, const Visit &visit) {
    const auto block = [&](int row, int col) -> const double * {
      const auto first = tangent.cols.begin() + tangent.row_offsets[static_cast<std::size_t>(row)];
      const auto last = tangent.cols.begin() + tangent.row_offsets[static_cast<std::size_t>(row) + 1];
      const auto at = std::lower_bound(first, last, col);
      return at != last && *at == col ? &tangent.values[9 * static_cast<std::size_t>(at - tangent.cols.begin())] : nullptr;
    };
    for (int row = 0; row + 1 < static_cast<int>(tangent.row_offsets.size()); ++row)
      for (auto e = tangent.row_offsets[static_cast<std::size_t>(row)]; e < tangent.row_offsets[static_cast<std::size_t>(row) + 1]; ++e) {
        const int col = tangent.cols[static_cast<std::size_t>(e)];
        const double *here = block(row, col), *across = block(col, row);
        if (row == col)
          visit({row}, {{0, 0, here}});
        else if (across == nullptr)
          visit({row, col}, {{0, 1, here}});
        else if (row < col)
          visit({row, col}, {{0, 1, here}, {1, 0, across}});
      }
  }

  // What the bodies cannot be, such as a cell that is inverted, is for FEBio a residual that is no number: it tries the step again in
  // parts. Any other failure ends the run.
  template <class Call>
  void guarded(const Call &call) {
    try {
      call();
    } catch (const fmc::Error &error) {
      feLogError("fmc contact: %s\n", error.what());
      if (error.status_class() == FMC_CLASS_GEOMETRY || error.status_class() == FMC_CLASS_NUMERICAL) throw NANInResidualDetected();
      throw;
    }
  }

  double stiffness_ = 0, friction_ = 0, tolerance_ = 0;
  vec3d point_{0, 0, 0}, normal_{0, 0, 0};
  std::unique_ptr<fmc::Context> contact_;
  std::array<int, 3> dofs_{};
  bool is_called_ = false;

  DECLARE_FECORE_CLASS();
};

BEGIN_FECORE_CLASS(FmcContact, FENLConstraint)
  ADD_PARAMETER(stiffness_, FE_RANGE_GREATER(0.0), "stiffness");
  ADD_PARAMETER(friction_, FE_RANGE_GREATER_OR_EQUAL(0.0), "friction");
  ADD_PARAMETER(tolerance_, FE_RANGE_GREATER_OR_EQUAL(0.0), "penetration");
  ADD_PARAMETER(point_, "floor_point");
  ADD_PARAMETER(normal_, "floor_normal");
END_FECORE_CLASS();

}  // namespace

FECORE_EXPORT unsigned int GetSDKVersion() { return FE_SDK_VERSION; }

FECORE_EXPORT void PluginInitialize(FECoreKernel &kernel) {
  FECoreKernel::SetInstance(&kernel);
  REGISTER_FECORE_CLASS(FmcContact, "fmc contact");
}
