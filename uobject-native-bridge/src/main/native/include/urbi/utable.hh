/// Callbacks and variables by name.
#ifndef URBI_UTABLE_HH
#define URBI_UTABLE_HH

#include <list>
#include <string>

#include <libport/hash.hh>
#include <libport/safe-container.hh>

#include <urbi/export.hh>
#include <urbi/uvalue.hh>

namespace urbi
{
  class UTimerCallback;

  /// Callbacks by name.
  struct UTable
    : std::unordered_map<std::string, libport::SafeContainer<std::list, UGenericCallback*>>
  {
    typedef libport::SafeContainer<std::list, UGenericCallback*> callbacks_type;

    /// Those of a name; null for none.
    callbacks_type* find0(const std::string& name)
    {
      iterator found = find(name);
      return found == end() ? nullptr : &found->second;
    }

    void clean(const std::string& name)
    {
      erase(name);
    }
  };

  /// Variables by name.
  struct UVarTable : std::unordered_map<std::string, std::list<UVar*>>
  {
    typedef std::list<UVar*> callbacks_type;

    callbacks_type* find0(const std::string& name)
    {
      iterator found = find(name);
      return found == end() ? nullptr : &found->second;
    }

    void clean(const UVar& variable)
    {
      for (auto& each : *this)
        each.second.remove(const_cast<UVar*>(&variable));
    }
  };

  typedef std::list<UTimerCallback*> UTimerTable;
}

#endif
