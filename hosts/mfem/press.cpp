// A block is pressed into a larger one and lifted by half, in MFEM from C++: meshes that do not match, and nothing to choose.
//
//   c++ -std=c++17 press.cpp -lmfem $(pkg-config --cflags --libs fmc_contact)
//   ./a.out                    as press.py
//   ./a.out pressed.txt 1e7    with the displacements in a file, and a stiffness of the contact in place of the library's
#include <fmc_contact.hpp>
#include <mfem.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>

int main(int argc, char **argv) try {
  // 1. Two blocks of hexahedra in one mesh. They touch from the start.
  auto lower = mfem::Mesh::MakeCartesian3D(4, 4, 4, mfem::Element::HEXAHEDRON, 1, 1, 1);
  auto upper = mfem::Mesh::MakeCartesian3D(3, 3, 3, mfem::Element::HEXAHEDRON, 0.6, 0.6, 0.6);
  for (int v = 0; v < upper.GetNV(); v++)
    for (int axis = 0; axis < 3; axis++) upper.GetVertex(v)[axis] += axis == 2 ? 1.0 : 0.2;
  mfem::Mesh *both[] = {&lower, &upper};
  mfem::Mesh mesh(both, 2);
  mfem::Array<int> hexes, corners;
  for (int e = 0; e < mesh.GetNE(); e++) mesh.GetElementVertices(e, corners), hexes.Append(corners);

  // 2. The bodies without contact: internal forces at displacements u, and their derivative.
  mfem::H1_FECollection order_one(1, 3);
  mfem::FiniteElementSpace space(&mesh, &order_one, 3, mfem::Ordering::byVDIM);
  mfem::ConstantCoefficient lambda(0.3e6 / (1.3 * 0.4)), mu(1e6 / 2.6);
  mfem::BilinearForm form(&space);
  form.AddDomainIntegrator(new mfem::ElasticityIntegrator(lambda, mu));
  form.Assemble();
  form.Finalize();
  const mfem::SparseMatrix &K = form.SpMat();
  const fmc::Bodies bodies = [&K](fmc::View<const double> u, double *forces, fmc::Csr<int64_t> *matrix) {
    mfem::Vector f(forces, K.Height());
    K.Mult(mfem::Vector(const_cast<double *>(u.data()), K.Width()), f);
    if (matrix != nullptr) {
      matrix->row_offsets.assign(K.GetI(), K.GetI() + K.Height() + 1);
      matrix->cols.assign(K.GetJ(), K.GetJ() + K.NumNonZeroElems());
      matrix->values.assign(K.GetData(), K.GetData() + K.NumNonZeroElems());
    }
    return true;
  };

  // 3. The contact. MFEM's vectors and arrays are taken as they are.
  mfem::GridFunction nodes(&space), u(&space);
  mesh.GetNodes(nodes);
  fmc::Context contact(3, nodes, {{FMC_HEX8, hexes}}, fmc::Options(argc > 2 ? std::atof(argv[2]) : 0));

  // 4. Bottom and top are held, and the top is moved: two load steps, the second from the end of the first.
  u = 0.0;
  std::vector<uint8_t> free(nodes.Size());
  for (int k = 0; k < nodes.Size(); k++) free[k] = nodes(k / 3 * 3 + 2) > 0 && nodes(k / 3 * 3 + 2) < 1.599;
  std::ofstream file(argc > 1 ? argv[1] : "");
  file.precision(17);
  for (const double push : {0.01, 0.005}) {
    mfem::Vector goal(u);
    for (int k = 2; k < nodes.Size(); k += 3) goal(k) = nodes(k) > 1.599 ? -push : 0;
    const fmc::Equilibrium found = fmc::find_equilibrium(contact, {{}, nodes, free, u, goal}, bodies);
    for (const auto &text : found.texts) std::puts(text.c_str());
    if (found.way == FMC_WAY_NONE) return 1;
    std::copy(found.x.begin(), found.x.end(), u.begin());
    contact.evaluate(mfem::Vector(nodes) += u);
    std::printf("pushed by %g: force %.6f, %zu linear solves\n", push, contact.body(1).force[2], found.counts.solve_count);
    u.Print(file, 3);
  }
} catch (const std::exception &error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
