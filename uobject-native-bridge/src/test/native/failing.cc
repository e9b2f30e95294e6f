// What goes wrong in C++ code, for those who look whether memory is lost by it.
#include <urbi/uobject.hh>

struct Strange
{};

class Failing : public urbi::UObject
{
public:
  Failing(const std::string& s)
    : urbi::UObject(s)
    , text(s)
  {
    UBindVars(Failing, v, w);
    UBindFunctions(Failing, runtime, memory, strange, elsewhere, twice, large);
    UNotifyChange(v, &Failing::changed);
    UNotifyAccess(w, &Failing::accessed);
    w = 1;
    if (s == "doomed")
      throw std::runtime_error("not today");
  }

  void runtime()
  {
    throw std::runtime_error("bad weather");
  }

  void memory()
  {
    throw std::bad_alloc();
  }

  void strange()
  {
    throw Strange();
  }

  double elsewhere()
  {
    urbi::UVar x("nowhere", "x");
    return x;
  }

  void changed(int n)
  {
    if (n > 1)
      throw std::runtime_error("too much");
  }

  void accessed()
  {
    throw std::runtime_error("not yours");
  }

  /// Objects that C++ code makes by itself.
  std::string twice()
  {
    Failing first("first"), second("second");
    first.v = 1;
    return first.text + second.text;
  }

  /// More than fits into the buffers of a call.
  std::string large(const std::string& given)
  {
    v.unnotify();
    v = std::string(100000, 'x') + given;
    return v.as<std::string>() + static_cast<std::string>(v);
  }

  std::string text;
  urbi::UVar v, w;
};

UStart(Failing);
