/// Contents of files.
#ifndef LIBPORT_FILE_SYSTEM_HH
#define LIBPORT_FILE_SYSTEM_HH

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <libport/lexical-cast.hh>

namespace libport
{
  /// All that can be read from a stream.
  inline std::string read_stream(std::istream& in)
  {
    return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }

  /// The contents of a file; "-" is standard input. \throw std::runtime_error
  inline std::string read_file(const std::string& file)
  {
    if (file == "-")
      return read_stream(std::cin);
    std::ifstream in(file.c_str(), std::ios::binary);
    if (!in)
      throw std::runtime_error("cannot read " + file + ": " + std::strerror(errno));
    return read_stream(in);
  }

  /// What the text of a file says. \throw std::runtime_error
  template <typename T>
  T file_contents_get(const std::string& file)
  {
    return lexical_cast<T>(read_file(file));
  }

  template <typename T>
  void file_contents_set(const std::string& file, const T& contents)
  {
    std::ofstream out(file.c_str(), std::ios::binary);
    if (!(out << contents << std::flush))
      throw std::runtime_error("cannot write " + file + ": " + std::strerror(errno));
  }
}

#endif
