/// A main of one's own: `UMAIN();` or `urbi::main`, in a program that is linked with its UObjects. It has
/// to export its symbols: link it with `-rdynamic`, as `umake -m` does.
#ifndef URBI_UMAIN_HH
#define URBI_UMAIN_HH

#include <string>
#include <vector>

#include <libport/cli.hh>

#include <urbi/exit.hh>
#include <urbi/uobject.hh>
#include <urbi/urbi-root.hh>

/// A function main that does nothing but to run the UObjects of its program.
#define UMAIN()                                                                                          \
  int main(int argc, const char** argv)                                                                  \
  {                                                                                                      \
    UrbiRoot root(argv[0]);                                                                              \
    return root.urbi_main(std::vector<std::string>(argv, argv + argc), true, false);                     \
  }                                                                                                      \
  int main_args(const libport::cli_args_type& args);                                                     \
  int main_args(const libport::cli_args_type& args)                                                      \
  {                                                                                                      \
    UrbiRoot root(args.at(0));                                                                           \
    return root.urbi_main(args, true, false);                                                            \
  }

extern "C"
{
  inline int urbi_main_args(const libport::cli_args_type& args, UrbiRoot& root, bool block, bool errors)
  {
    return root.urbi_main(args, block, errors);
  }

  inline int urbi_main(int argc, const char* argv[], UrbiRoot& root, bool block, bool errors)
  {
    return root.urbi_main(std::vector<std::string>(argv, argv + argc), block, errors);
  }
}

namespace urbi
{
  /// Runs the UObjects of this program: see UrbiRoot::urbi_main.
  inline int main(const libport::cli_args_type& args, UrbiRoot& root, bool block = true,
                  bool errors = false)
  {
    return root.urbi_main(args, block, errors);
  }

  inline int main(int argc, const char* argv[], UrbiRoot& root, bool block = true, bool errors = false)
  {
    return root.urbi_main(std::vector<std::string>(argv, argv + argc), block, errors);
  }

  inline int main(int argc, const char* argv[], bool block = true, bool errors = false)
  {
    UrbiRoot root(argv[0]);
    return main(argc, argv, root, block, errors);
  }
}

#endif
