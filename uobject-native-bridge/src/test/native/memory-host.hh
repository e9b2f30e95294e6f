/// A host for one module, which keeps everything in memory: it calls the module and is called by it
/// as the Java host does, and can be watched by what watches C++ code.
#ifndef MEMORY_HOST_HH
#define MEMORY_HOST_HH

#include <functional>
#include <list>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <urbi/detail/wire.hh>

/// The functions of a module.
struct Entries
{
  typedef int64_t (*Call)(urbi_exchange*);
  int64_t (*open)(urbi_host, urbi_exchange*);
  Call create;
  Call destroy;
  Call invoke;
  Call forget;
  void (*free)(void*);
};

class MemoryHost
{
public:
  typedef urbi::UValue UValue;
  typedef std::vector<const UValue*> Values;

  explicit MemoryHost(const Entries& module)
    : module_(module)
  {
    current() = this;
    std::string declared = exchange(0, 0, nullptr, [this](urbi_exchange* e) {
      return module_.open(&MemoryHost::request, e);
    });
    urbi::detail::Reader in(reinterpret_cast<const uint8_t*>(declared.data()),
                            static_cast<int64_t>(declared.size()));
    while (!in.ended())
    {
      std::string kind = in.text();
      std::string name = in.text();
      if (kind == "hub")
        create(1, name, name);
      else
        classes.insert(name);
    }
  }

  ~MemoryHost()
  {
    while (!objects.empty())
      destroy(objects.begin()->first);
    for (const auto& hub : hubs)
      exchange(1, hub.second, nullptr, module_.destroy);
    exchange(0, 0, nullptr, module_.forget);
    current() = nullptr;
  }

  MemoryHost(const MemoryHost&) = delete;
  MemoryHost& operator=(const MemoryHost&) = delete;

  // ---------------------------------------------------------------- what a kernel would do

  void make(const std::string& className, const std::string& name)
  {
    create(0, className, name);
  }

  void destroy(std::string name)
  {
    int64_t address = objects.at(name);
    objects.erase(name);
    for (auto each = timers.begin(); each != timers.end();)
      each = each->second.owner == name ? timers.erase(each) : std::next(each);
    for (auto& variable : variables)
      for (auto* all : {&variable.second.onChange, &variable.second.onAccess})
        all->remove_if([&](const Callback& each) { return each.owner == name; });
    exchange(0, address, nullptr, module_.destroy);
  }

  UValue call(const std::string& function, const Values& arguments)
  {
    return invoke(functions.at(function), arguments, true);
  }

  /// Writes as urbiscript does.
  void set(const std::string& variable, const UValue& value)
  {
    Variable& written = variables[variable];
    (written.owned ? written.target : written.value) = value;
    tell(variable, value, true);
  }

  /// Reads as urbiscript does.
  UValue get(const std::string& variable)
  {
    for (const Callback& each : copy(variables[variable].onAccess))
      invoke(each, {}, true);
    return variables[variable].value;
  }

  void link(const std::string& source, const std::string& target)
  {
    variables[source].links.push_back(target);
  }

  /// All timers are due.
  void tick()
  {
    std::map<int64_t, Callback> due = timers;
    for (const auto& each : due)
      if (timers.count(each.first))
        invoke(each.second, {}, true);
  }

  std::set<std::string> classes;
  std::list<std::string> sent;

private:
  struct Callback
  {
    std::string owner;
    int64_t address;
    int64_t arity;
    int64_t mode; ///< -1 if it has no thread of its own
  };

  struct Variable
  {
    UValue value;
    UValue target;
    bool owned = false;
    bool bypass = false;
    bool told = false;
    std::list<Callback> onChange;
    std::list<Callback> onAccess;
    std::list<std::string> links;
    std::map<int64_t, UValue> properties;
  };

  static MemoryHost*& current()
  {
    static MemoryHost* one = nullptr;
    return one;
  }

  static std::list<Callback> copy(const std::list<Callback>& all)
  {
    return all;
  }

  // ---------------------------------------------------------------- calls into the module

  std::string exchange(int64_t operation, int64_t subject, urbi::detail::Writer* data,
                       const std::function<int64_t(urbi_exchange*)>& function, int64_t* result = nullptr)
  {
    uint8_t buffer[64];
    urbi_exchange e = {operation, 1, subject, data ? data->data() : nullptr,
                       data ? data->size() : 0, buffer, sizeof buffer, 0};
    int64_t status = function(&e);
    std::string reply(reinterpret_cast<char*>(e.reply), static_cast<size_t>(e.reply_length));
    if (e.reply != buffer)
      module_.free(e.reply);
    if (status == URBI_FAILED)
      throw std::runtime_error(reply);
    if (result)
      *result = status;
    return reply;
  }

  void create(int64_t kind, const std::string& className, const std::string& name)
  {
    uint8_t buffer[64];
    urbi::detail::Writer data(buffer, sizeof buffer, true);
    data.text(className);
    data.text(name);
    names[++last] = name;
    if (!kind)
      objects[name] = 0;
    int64_t address = 0;
    try
    {
      exchange(kind, last, &data, module_.create, &address);
    }
    catch (const std::exception&)
    {
      objects.erase(name);
      throw;
    }
    (kind ? hubs : objects)[name] = address;
  }

  UValue invoke(const Callback& callback, const Values& arguments, bool whole)
  {
    uint8_t buffer[64];
    urbi::detail::Writer data(buffer, sizeof buffer, whole);
    for (const UValue* each : arguments)
      data.value(*each);
    std::string reply;
    std::string error;
    auto run = [&] {
      try
      {
        reply = exchange(0, callback.address, &data, module_.invoke);
      }
      catch (const std::exception& e)
      {
        error = e.what();
      }
    };
    if (callback.mode < 0)
      run();
    else
      std::thread(run).join();
    if (!error.empty())
      throw std::runtime_error(error);
    UValue result;
    urbi::detail::Reader(reinterpret_cast<const uint8_t*>(reply.data()),
                         static_cast<int64_t>(reply.size()))
      .value(result);
    return result;
  }

  void tell(const std::string& name, const UValue& value, bool whole)
  {
    Variable& variable = variables[name];
    if (variable.told)
      return;
    variable.told = true;
    try
    {
      for (const Callback& each : copy(variable.onChange))
      {
        Values arguments;
        if (each.arity || !whole)
          arguments.push_back(&value);
        invoke(each, arguments, whole);
      }
      for (const std::string& target : variable.links)
      {
        if (whole)
          variables[target].value = value;
        tell(target, value, whole);
      }
    }
    catch (...)
    {
      variable.told = false;
      throw;
    }
    variable.told = false;
  }

  // ---------------------------------------------------------------- what the module asks for

  static int64_t request(urbi_exchange* e)
  {
    urbi::detail::Writer out(e->reply, e->reply_capacity, true);
    int64_t result;
    try
    {
      urbi::detail::Reader in(e->data, e->length);
      if (!current())
        throw std::runtime_error("the kernel has ended");
      result = current()->carry_out(e->operation, e->subject, in, out);
    }
    catch (const std::exception& error)
    {
      result = URBI_FAILED;
      out.restart();
      out.bytes(error.what(), std::strlen(error.what()));
    }
    e->reply_length = out.size();
    e->reply = out.release();
    return result;
  }

  Callback callback(urbi::detail::Reader& in, const std::string& owner)
  {
    Callback made;
    made.owner = owner;
    made.address = in.raw<int64_t>();
    made.arity = in.raw<int64_t>();
    made.mode = in.raw<int64_t>();
    in.raw<int64_t>();
    return made;
  }

  void write(const std::string& name, urbi::detail::Reader& in)
  {
    UValue value;
    in.value(value);
    Variable& variable = variables[name];
    if (variable.bypass && value.type == urbi::DATA_BINARY)
    {
      tell(name, value, false);
      return;
    }
    variable.value = value;
    if (!variable.owned)
      tell(name, value, true);
  }

  int64_t carry_out(int64_t operation, int64_t subject, urbi::detail::Reader& in,
                    urbi::detail::Writer& out)
  {
    const std::string& name = names[subject];
    switch (operation)
    {
    case URBI_MODE: return 1;
    case URBI_OBJECT_NEW:
      ++last;
      names[last] = "object_" + std::to_string(last);
      objects[names[last]] = 0;
      out.text(names[last]);
      return last;
    case URBI_OBJECT_GONE: objects.erase(name); return 0;
    case URBI_OBJECT_FIND: return find(objects, in.text());
    case URBI_HUB_FIND: return find(hubs, in.text());
    case URBI_FUNCTION:
    {
      std::string function = in.text();
      functions[name + "." + function] = callback(in, name);
      return 0;
    }
    case URBI_EVERY:
      in.raw<double>();
      in.raw<int64_t>();
      timers[++last] = callback(in, name);
      return last;
    case URBI_TIMER_END: timers.erase(subject); return 0;
    case URBI_VARIABLE:
    {
      std::string variable = in.text();
      if (!objects.count(variable.substr(0, variable.rfind('.'))))
        throw std::runtime_error("UVar creation on non existing object: " + variable);
      names[++last] = variable;
      return last;
    }
    case URBI_VARIABLE_GET:
    case URBI_VARIABLE_SYNC:
      out.value(variables[name].owned ? variables[name].target : variables[name].value);
      return 0;
    case URBI_VARIABLE_SET: write(name, in); return 0;
    case URBI_VARIABLE_BYPASS: variables[name].bypass = in.raw<int64_t>() != 0; return 1;
    case URBI_VARIABLE_OWN:
      variables[name].owned = true;
      variables[name].target = variables[name].value;
      return 0;
    case URBI_VARIABLE_CHANGE:
    case URBI_VARIABLE_ACCESS:
    {
      std::string owner = names[in.raw<int64_t>()];
      auto& all = operation == URBI_VARIABLE_CHANGE ? variables[name].onChange
                                                    : variables[name].onAccess;
      all.push_back(callback(in, owner));
      return 0;
    }
    case URBI_VARIABLE_GET_PROPERTY: out.value(variables[name].properties[in.raw<int64_t>()]); return 0;
    case URBI_VARIABLE_SET_PROPERTY:
    {
      int64_t property = in.raw<int64_t>();
      in.value(variables[name].properties[property]);
      return 0;
    }
    case URBI_CONVERT:
    {
      // Only the Java host can; whoever asks gets what it has.
      UValue source;
      in.value(source);
      out.value(source);
      return 0;
    }
    case URBI_SEND:
    case URBI_REPORT: sent.push_back(in.text()); return 0;
    case URBI_EVENT: names[++last] = in.text(); return last;
    case URBI_VARIABLE_CLOSE:
    case URBI_EVENT_CLOSE: names.erase(subject); return 0;
    default: return 0;
    }
  }

  static int64_t find(const std::map<std::string, int64_t>& all, const std::string& name)
  {
    auto found = all.find(name);
    return found == all.end() ? 0 : found->second;
  }

  Entries module_;
  int64_t last = 0;
  std::map<int64_t, std::string> names; ///< of objects, variables and events, by their numbers
  std::map<std::string, int64_t> objects;
  std::map<std::string, int64_t> hubs;
  std::map<std::string, Callback> functions;
  std::map<std::string, Variable> variables;
  std::map<int64_t, Callback> timers;
};

#endif
