/// Where Urbi is, and programs that run UObjects of their own.
#ifndef URBI_URBI_ROOT_HH
#define URBI_URBI_ROOT_HH

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include <unistd.h>

#include <libport/detect-win32.h>
#include <libport/windows.hh>

#include <urbi/detail/java-machine.hh>
#include <urbi/export.hh>

/// An installation of Urbi: that of the variable URBI_ROOT, or the one with whose headers the program
/// was compiled.
class UrbiRoot
{
public:
  /// \param program how the program was called
  explicit UrbiRoot(const std::string& program, bool = false)
    : program_(program)
    , root_(find())
  {}

  /// Becomes the program `urbi-launch`, with these arguments. Returns if that is not possible.
  int urbi_launch(int argc, char** argv)
  {
    std::string launch = root_ + "/bin/urbi-launch";
    std::vector<char*> words(argv, argv + argc);
    words.push_back(nullptr);
    execv(launch.c_str(), words.data());
    std::cerr << program_ << ": cannot run " << launch << std::endl;
    return 1;
  }

  int urbi_launch(int argc, const char** argv)
  {
    return urbi_launch(argc, const_cast<char**>(argv));
  }

  /// Has the UObjects of this program run in this process, and returns when they are connected.
  /// \param options those of `urbi-launch --remote`
  /// \param ends    whether the program ends with the connection
  int start(std::vector<std::string> options, bool ends)
  {
    options.insert(options.begin(), program_);
    return urbi::detail::JavaMachine::of(root_).call("org/urbi/bridge/NativeProgram", "start", options,
                                                     ends);
  }

  /// Runs the UObjects of this program in this process, connected to a server: the options are those of
  /// `urbi-launch --remote`.
  /// \param args   the name of the program, and options
  /// \param block  return when the connection has ended, and not as soon as the UObjects run
  /// \param errors throw what goes wrong, and do not print it
  /// \return the exit status
  int urbi_main(const std::vector<std::string>& args, bool block, bool errors)
  {
    try
    {
      std::vector<std::string> words(args.begin() + (args.empty() ? 0 : 1), args.end());
      words.insert(words.begin(), program_);
      return urbi::detail::JavaMachine::of(root_).call("org/urbi/bridge/NativeProgram", "run", words,
                                                       block);
    }
    catch (const std::exception& e)
    {
      if (errors)
        throw;
      std::cerr << program_ << ": " << e.what() << std::endl;
      return 1;
    }
  }

  /// A program runs its UObjects remote; where they are plugged in, a server has loaded them.
  void load_remote() {}
  void load_plugin() {}
  void load_custom(const std::string&) {}

  const std::string& root() const
  {
    return root_;
  }

  std::string core_path() const
  {
    return root_;
  }

  std::string doc_dir() const
  {
    return root_ + "/docs";
  }

  std::string share_dir() const
  {
    return root_ + "/share";
  }

  /// Where modules are looked for.
  std::vector<std::string> uobjects_path() const
  {
    std::vector<std::string> all;
    const char* own = std::getenv("URBI_UOBJECT_PATH");
    std::string path = own ? own : ".";
    for (size_t from = 0; from <= path.size();)
    {
      size_t to = path.find(':', from);
      if (to == std::string::npos)
        to = path.size();
      all.push_back(to == from ? std::string(".") : path.substr(from, to - from));
      from = to + 1;
    }
    return all;
  }

  std::string library_suffix() const
  {
    return std::string();
  }

private:
  static std::string find()
  {
    const char* own = std::getenv("URBI_ROOT");
    if (own && *own)
      return own;
    // This file is in ROOT/include/urbi.
    std::string here = __FILE__;
    for (int i = 0; i < 3; ++i)
      here.erase(here.rfind('/') == std::string::npos ? 0 : here.rfind('/'));
    return here.empty() ? std::string(".") : here;
  }

  std::string program_;
  std::string root_;
};

#endif
