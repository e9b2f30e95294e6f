#include <vector>

#include <urbi/uobject.hh>

struct Point
{
  Point()
    : x(0), y(0)
  {}

  Point(double xx, double yy)
    : x(xx), y(yy)
  {}

  double x, y;
};

URBI_REGISTER_STRUCT(Point, x, y);

/// A temperature, which is a number of kelvins to urbiscript.
struct Temperature
{
  double celsius;
};

namespace urbi
{
  void operator, (UValue& v, const Temperature& t)
  {
    v = t.celsius + 273;
  }

  template<> struct uvalue_caster<Temperature>
  {
    Temperature operator()(UValue& v)
    {
      return Temperature{static_cast<ufloat>(v) - 273};
    }
  };
}

/// Takes and gives structures.
class MyObject : public urbi::UObject
{
public:
  MyObject(const std::string& s)
    : urbi::UObject(s)
  {
    UBindVar(MyObject, val);
    UBindFunctions(MyObject, opposite, writePoint, xCoord, centre, warmer, pair, table, twin);
  }

  Point opposite(Point p)
  {
    return Point(-p.x, -p.y);
  }

  void writePoint(Point p)
  {
    UVar v(this, "val");
    v = p;
  }

  ufloat xCoord()
  {
    UVar v(this, "val");
    Point p;
    v.fill(p);
    p = v.as<Point>();
    return p.x;
  }

  Point centre(const std::vector<Point>& all)
  {
    Point sum;
    for (const Point& each : all)
    {
      sum.x += each.x / static_cast<double>(all.size());
      sum.y += each.y / static_cast<double>(all.size());
    }
    return sum;
  }

  Temperature warmer(Temperature t)
  {
    return Temperature{t.celsius + 1};
  }

  std::vector<std::string> pair(const std::list<int>& numbers, const char* text)
  {
    return std::vector<std::string>(numbers.size(), text);
  }

  UDictionary table(const UList& list)
  {
    UDictionary made;
    for (size_t i = 0; i < list.size(); ++i)
      made[list[i]] = static_cast<int>(i);
    return made;
  }

  UObject* twin(UObject* other)
  {
    return other == this ? 0 : other;
  }

  UVar val;
};

UStart(MyObject);
