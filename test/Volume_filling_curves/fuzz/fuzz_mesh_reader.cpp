// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Feeds arbitrary bytes, and words chosen by them, to the program's readers of meshes. What is
// accepted must also bound a domain for the library, and each defect takes one line. Build with
// clang++ -fsanitize=fuzzer,address,undefined.

#include "fuzz/words_of_meshes.h"
#include "meshes/examine_mesh.h"
#include "meshes/read_mesh_soup.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

#include <unistd.h>

namespace {

void require(bool condition)
{
  if(!condition) std::abort();
}

// Files in memory where there is such a folder; each process has its own.
std::string path_of(const std::string& extension)
{
  const std::string name = "fuzz_mesh_reader_" + std::to_string(getpid()) + extension;
  return (access("/dev/shm", W_OK) == 0 ? "/dev/shm/" : "./") + name;
}

void read(const std::string& extension, const std::string& bytes)
{
  const std::string file = path_of(extension);
  std::ofstream(file, std::ios::binary) << bytes;
  vfc::Mesh_findings findings(file);
  const vfc::Mesh_and_defects result = vfc::examine(vfc::read_mesh_soup(file, findings), findings);
  std::remove(file.c_str());
  require(result.is_valid != findings.has_error());
  for(const vfc::Defect& defect : findings.list())
    require(defect.text.find('\n') == std::string::npos);
  if(result.is_valid) vfc::Domain domain(result.mesh);
}

// Every byte is a word; such texts get further than arbitrary ones.
std::string text_of(const mesh_words::Words& choice, const std::uint8_t* data, std::size_t size)
{
  std::string text;
  for(std::size_t i = 0; i < size; ++i) text += choice[data[i] % choice.size()];
  return text;
}

const std::pair<const char*, mesh_words::Words> formats[] = {{".off", mesh_words::words_of_off},
                                                             {".obj", mesh_words::words_of_obj},
                                                             {".ply", mesh_words::words_of_ply},
                                                             {".stl", mesh_words::words_of_stl},
                                                             {".vtp", mesh_words::words_of_vtp}};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for(const auto& [extension, choice] : formats) {
    read(extension, bytes);
    read(extension, text_of(choice, data, size));
  }
  return 0;
}
