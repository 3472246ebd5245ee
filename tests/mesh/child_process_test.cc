// Whatever happens in the child, the parent hears of it and lives on.

#include "../temporary_directory.h"

#include <rift/base/exceptions.h>
#include <rift/mesh/child_process.h>
#include <rift/mesh/mesh_buffer.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

using namespace rift;

namespace
{
  std::string
  death_of(const std::function<std::string()> &work)
  {
    return message_of<ChildProcessError>([&]() { run_in_child_process(work); });
  }
} // namespace

TEST(ChildProcess, BytesComeBack)
{
  std::string sent(1000000, '\0');
  for (std::size_t i = 0; i < sent.size(); ++i)
    sent[i] = static_cast<char>(i * i);
  EXPECT_EQ(run_in_child_process([&]() { return sent; }), sent);
  EXPECT_EQ(run_in_child_process([]() { return std::string(); }), "");
}

TEST(ChildProcess, NothingElseComesBack)
{
  static int state = 1;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run_in_child_process([]() {
    state = 2;
    std::puts("printed");
    std::fputs("printed", stderr);
    std::fflush(nullptr);
    return std::string();
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(state, 1);
}

TEST(ChildProcess, Errors)
{
  EXPECT_EQ(message_of<InputError>([]() {
              run_in_child_process(
                []() -> std::string { throw InputError("no mesh"); });
            }),
            "no mesh");
  EXPECT_EQ(death_of([]() -> std::string { throw std::out_of_range("here"); }),
            "failed: here");
  EXPECT_EQ(death_of([]() -> std::string { std::exit(0); }),
            "ended early with exit code 0");
  EXPECT_EQ(death_of([]() -> std::string { _Exit(7); }),
            "ended early with exit code 7");
  EXPECT_EQ(death_of([]() -> std::string {
              std::raise(SIGSEGV);
              return "";
            }),
            "was killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(death_of([]() -> std::string {
              return std::string(std::size_t(1) << 50, 'x');
            }),
            "ran out of memory");
  const auto need_100_MB = []() { return std::string(100000000, 'x'); };
  EXPECT_EQ(run_in_child_process(need_100_MB).size(), 100000000u);
  EXPECT_EQ(message_of<ChildProcessError>(
              [&]() { run_in_child_process(need_100_MB, 90000000); }),
            "ran out of memory");
}

TEST(MeshBuffer, EverythingIsPacked)
{
  MeshData mesh;
  mesh.source         = "a.msh";
  mesh.vertices       = {{{1, 2, 3}}, {{4, 5, 6}}};
  mesh.cells          = {{{0, 1, 2, 3}}};
  mesh.cell_tags      = {99};
  mesh.cell_materials = {3};
  mesh.material_names = {"", "granite"};
  mesh.surface_names  = {"left"};
  mesh.boundary_faces = {{1, 2, 3}};
  mesh.internal_faces = {{4, 3, 2}, {5, 6, 7}};

  const std::string buffer = pack_mesh(mesh);
  const MeshData    copy   = unpack_mesh(buffer);
  EXPECT_EQ(copy.source, mesh.source);
  EXPECT_EQ(copy.vertices, mesh.vertices);
  EXPECT_EQ(copy.cells, mesh.cells);
  EXPECT_EQ(copy.cell_tags, mesh.cell_tags);
  EXPECT_EQ(copy.cell_materials, mesh.cell_materials);
  EXPECT_EQ(copy.material_names, mesh.material_names);
  EXPECT_EQ(copy.surface_names, mesh.surface_names);
  ASSERT_EQ(copy.boundary_faces.size(), 1u);
  EXPECT_EQ(copy.boundary_faces[0].local_face, 2);
  ASSERT_EQ(copy.internal_faces.size(), 2u);
  EXPECT_EQ(copy.internal_faces[1].cell, 5u);
  EXPECT_EQ(copy.internal_faces[1].name, 7);

  for (std::size_t size = 0; size < buffer.size(); ++size)
    EXPECT_THROW(unpack_mesh(buffer.substr(0, size)), std::length_error);
}
