// What programs of 2.7 do with their context, with null and with bytes.
#include <urbi/uobject.hh>
#include <urbi/uclient.hh>

#include <pthread.h>
#include <stdexcept>
#include <string>

class Program : public urbi::UObject
{
public:
  Program(const std::string& s)
    : urbi::UObject(s)
    , thread_(pthread_self())
    , released_(false)
  {
    UBindVars(Program, v, last);
    UBindFunctions(Program, init, await, rest, release, calls, nothing, isNothing, reversed, server,
                   isOnItsThread, sum);
    last = 0;
    UNotifyChange(v, &Program::changed);
  }

  int init()
  {
    return 0;
  }

  /// Waits for `release`.
  std::string await(const std::string& name)
  {
    released_ = false;
    while (!released_)
      yield();
    return name;
  }

  /// Waits for seconds.
  int rest(urbi::ufloat seconds)
  {
    yield_for(static_cast<libport::utime_t>(seconds * 1e6));
    return 1;
  }

  void release()
  {
    released_ = true;
  }

  /// Has urbiscript code called, by a notification.
  int calls(int value)
  {
    v = value;
    return last;
  }

  urbi::UObject* nothing()
  {
    return nullptr;
  }

  bool isNothing(urbi::UObject* object)
  {
    return !object;
  }

  std::string reversed(const std::string& bytes)
  {
    return std::string(bytes.rbegin(), bytes.rend());
  }

  bool isOnItsThread()
  {
    return pthread_equal(thread_, pthread_self());
  }

  /// The port of the server of this process.
  int server()
  {
    urbi::UClient* client = urbi::getDefaultClient();
    return client ? static_cast<int>(client->getServerPort()) : 0;
  }

  /// Has the server add.
  int sum(int a, int b)
  {
    urbi::USyncClient* client = dynamic_cast<urbi::USyncClient*>(urbi::getDefaultClient());
    if (!client)
      throw std::runtime_error("no client");
    urbi::ufloat result = 0;
    client->syncGetResult((std::to_string(a) + "+" + std::to_string(b)).c_str(), result);
    return static_cast<int>(result);
  }

private:
  int changed(urbi::UVar& variable)
  {
    last = static_cast<int>(variable) + 1;
    return 0;
  }

  urbi::UVar v;
  urbi::UVar last;
  pthread_t thread_;
  bool released_;
};

UStart(Program);
