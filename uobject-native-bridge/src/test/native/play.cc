// Plays dialogues, each with the library of its module: play MODULE.so DIALOGUE… Run under Valgrind and with
// AddressSanitizer, which can look at C++ code by itself, and not at a Java virtual machine.
#include <urbi/uobject.hh>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

#include <dlfcn.h>

#include "memory-host.hh"

static void* library;

template <typename Function>
static void find(Function& function, const char* name)
{
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (!function)
    throw std::runtime_error(std::string("no symbol ") + name);
}

static Entries entries(const char* file)
{
  library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (!library)
    throw std::runtime_error(dlerror());
  Entries found;
  find(found.open, "urbi_module_open");
  find(found.create, "urbi_module_create");
  find(found.destroy, "urbi_module_destroy");
  find(found.invoke, "urbi_module_invoke");
  find(found.forget, "urbi_module_forget");
  find(found.free, "urbi_module_free");
  return found;
}

static urbi::UValue literal(const std::string& text)
{
  urbi::UValue value;
  if (!urbi::detail::read_literal(text, value))
    throw std::runtime_error("no literal: " + text);
  return value;
}

/// What a line of the dialogue asks for; what it answers, or the text of an exception.
static std::string play(MemoryHost& host, const std::string& verb, const std::string& name,
                        const std::string& rest)
{
  try
  {
    if (verb == "new")
      host.make(rest, name);
    else if (verb == "end")
      host.destroy(name);
    else if (verb == "set")
      host.set(name, literal(rest));
    else if (verb == "link")
      host.link(name, rest);
    else if (verb == "tick")
      host.tick();
    else if (verb == "get")
      return urbi::detail::literal_of(host.get(name));
    else if (verb == "call")
    {
      MemoryHost::Values arguments;
      urbi::UValue list = literal(rest.empty() ? "[]" : rest);
      for (size_t i = 0; i < list.list->size(); ++i)
        arguments.push_back(&(*list.list)[i]);
      urbi::UValue result = host.call(name, arguments);
      return result.type == urbi::DATA_VOID ? "" : urbi::detail::literal_of(result);
    }
    else
      return "what is " + verb + "?";
    return "";
  }
  catch (const std::exception& e)
  {
    return std::string("!") + e.what();
  }
}

/// Whether all is answered as it should.
static bool play(const char* module, const char* file)
{
  int failures = 0;
  int lines = 0;
  {
    std::ifstream dialogue(file);
    MemoryHost host(entries(module));
    for (const std::string& each : host.classes)
      host.make(each, each);
    std::string line;
    while (std::getline(dialogue, line))
    {
      if (line.empty() || line[0] == '#')
        continue;
      size_t arrow = line.find(" -> ");
      std::string expected = arrow == std::string::npos ? "" : line.substr(arrow + 4);
      std::istringstream words(line.substr(0, arrow));
      std::string verb, name, rest;
      words >> verb >> name >> std::ws;
      std::getline(words, rest);
      std::string answer = play(host, verb, name, rest);
      ++lines;
      if (answer != expected)
      {
        ++failures;
        std::printf("%s: %s: answered %s\n", file, line.c_str(), answer.c_str());
      }
    }
  }
  dlclose(library);
  if (!lines)
    std::printf("%s: no dialogue\n", file);
  return lines && !failures;
}

int main(int argc, char* argv[])
{
  if (argc < 3 || argc % 2 == 0)
    return 2;
  bool well = true;
  for (int i = 1; i < argc; i += 2)
    well = play(argv[i], argv[i + 1]) && well;
  return !well;
}
