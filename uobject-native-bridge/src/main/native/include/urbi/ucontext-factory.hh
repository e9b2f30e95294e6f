/// The contexts of a module, and its classes.
#ifndef URBI_UCONTEXT_FACTORY_HH
#define URBI_UCONTEXT_FACTORY_HH

#include <string>
#include <vector>

#include <urbi/ucontext-impl.hh>
#include <urbi/ustarter.hh>

namespace urbi
{
  namespace impl
  {
    /// The names of the classes of this module.
    inline std::vector<std::string> listModules()
    {
      std::vector<std::string> names;
      for (const baseURBIStarter* each : baseURBIStarter::list())
        names.push_back(each->name);
      return names;
    }

    /// The context of the kernel in this process; null if it is elsewhere.
    inline UContextImpl* getPluginContext()
    {
      UContextImpl* own = getCurrentContext();
      return own && own->getRunningMode() == MODE_PLUGIN ? own : nullptr;
    }

    /// The context that is connected to a server. \throw std::runtime_error if it is none of this
    /// process: urbi-launch --remote makes it
    inline UContextImpl* getRemoteContext(const std::string& host, const std::string& port)
    {
      UContextImpl* own = getCurrentContext();
      if (!own || own->getRunningMode() != MODE_REMOTE)
        throw std::runtime_error("no connection to " + host + ":" + port
                                 + ": let urbi-launch --remote make it");
      return own;
    }

    inline UContextImpl* makeRemoteContext(const std::string& host, const std::string& port)
    {
      return getRemoteContext(host, port);
    }
  }
}

#endif
