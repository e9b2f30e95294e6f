/// A main of one's own: `UMAIN();` or `urbi::main`, in a program that is linked with its UObjects. It has
/// to export its symbols: link it with `-rdynamic`, as `umake -m` does.
#ifndef URBI_UMAIN_HH
#define URBI_UMAIN_HH

#include <string>
#include <vector>

#include <libport/cli.hh>

#include <urbi/exit.hh>
#include <urbi/uclient.hh>
#include <urbi/uobject.hh>
#include <urbi/urbi-root.hh>

#define UMAIN_URBIROOT_STATIC false

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

  /// Has the UObjects of this program run, and returns when they are connected to the server.
  ///
  /// \param ends   whether the program ends with the connection
  /// \param server to wait for the server to connect, which is not possible here
  /// \param files  urbiscript to be sent to the server first
  /// \return 0 unless something is not possible, or there is no such server
  inline int initialize(const std::string& host, int port, size_t, bool ends, bool server = false,
                        const std::vector<std::string>& files = std::vector<std::string>(), bool = true)
  {
    if (server)
    {
      std::cerr << "urbi::initialize: servers do not connect to UObjects" << std::endl;
      return 1;
    }
    if (!files.empty())
    {
      UClient client(host, static_cast<unsigned>(port));
      for (const std::string& file : files)
        if (client.error() || client.sendFile(file))
          return 1;
    }
    return UrbiRoot("urbi").start({"--host", host, "--port", std::to_string(port)}, ends);
  }
}

#endif
