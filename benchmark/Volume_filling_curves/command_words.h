// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_COMMAND_WORDS_H
#define VFC_BENCHMARK_COMMAND_WORDS_H

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace vfc_benchmark {

// The command line of a benchmark: options, and between them what is to be measured, a file or a
// size, with the options that stand before it.

using Words = std::vector<std::string>;

// returns the value of the option words[k], and moves on to it
inline const std::string& value_of_option(const Words& words, std::size_t& k)
{
  if(k + 1 == words.size()) throw std::runtime_error(words[k] + " needs a value");
  return words[++k];
}

// Calls run(word) for every word that is no option, and returns the exit status of the program.
// read_option(words, k) returns whether words[k] is an option, and moves k to the last word of it.
template <typename ReadOption, typename Run>
int run_words(int argc, char** argv, const ReadOption& read_option, const Run& run)
{
  try {
    const Words words(argv + 1, argv + argc);
    for(std::size_t k = 0; k < words.size(); ++k)
      if(!read_option(words, k)) run(words[k]);
    return EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_COMMAND_WORDS_H
