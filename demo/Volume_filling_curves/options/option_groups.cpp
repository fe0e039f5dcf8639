// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/option_groups.h"

#include <initializer_list>
#include <string>

namespace vfc {
namespace {

struct Option_group
{
  const char* name;
  std::initializer_list<const char*> options;
};

const Option_group known_groups[] = {
    {"Input",
     {"--network", "--closed", "--open", "--free-ends", "--curve", "--start", "--obstacle"}},
    {"Shape of the result",
     {"--thickness-field", "--direction-field", "--direction-weight", "--wall", "--wall-distance",
      "--keep-length", "--bend-radius", "--strand-distance", "--symmetry", "--volume-shares"}},
    {"More outputs", {"--certificate", "--map", "--frames", "--every", "--frame-format"}},
    {"Interrupted runs", {"--checkpoint", "--save-every", "--resume"}},
    {"Many runs", {"--batch", "--shard", "--format"}},
    {"Flow and search",
     {"--max-iterations", "--seed", "--tolerance", "--chains", "--directions", "--rmax",
      "--spacing", "--lambda", "--beta", "--tau", "--preconditioner"}},
    {"General", {"--threads", "--quiet", "--verbose"}}};

// convert resamples with an option that has the name of a parameter of the flow.
bool is_for_few(const CLI::App& command, const std::string& name)
{
  return name != "--spacing" || command.get_name() != "convert";
}

} // namespace

void group_options(CLI::App& command)
{
  for(const Option_group& group : known_groups)
    for(const char* const name : group.options)
      if(CLI::Option* const option = command.get_option_no_throw(name))
        if(is_for_few(command, name)) option->group(group.name);
}

} // namespace vfc
