#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include <urbi/uobject.hh>

namespace
{
  /// What each device was commanded last.
  std::map<int, double> commanded;

  void setPositions(int count, int* ids, double* positions)
  {
    for (int i = 0; i < count; ++i)
      commanded[ids[i]] = positions[i];
  }
}

/// Sends the commands of all servos at the same time.
class servohub : public urbi::UObjectHub
{
public:
  servohub(const std::string&);

  virtual int update();

  void addValue(int id, double val);

  std::vector<int> ids;
  std::vector<double> vals;
};

/// A servo that gives its commands to the hub.
class servo : public urbi::UObject
{
public:
  servo(const std::string&);

  void init(int id);
  virtual int update();
  std::string last();
  int mates();

  urbi::UVar val;
  int id_;
};

servohub::servohub(const std::string& s)
  : UObjectHub(s)
{
  USetUpdate(1);
}

int servohub::update()
{
  setPositions(static_cast<int>(ids.size()), ids.data(), vals.data());
  ids.clear();
  vals.clear();
  return 0;
}

void servohub::addValue(int id, double val)
{
  if (std::find(ids.begin(), ids.end(), id) == ids.end())
  {
    ids.push_back(id);
    vals.push_back(val);
  }
}

UStartHub(servohub);

servo::servo(const std::string& s)
  : urbi::UObject(s)
  , id_(0)
{
  UBindFunction(servo, init);
}

void servo::init(int id)
{
  id_ = id;
  UBindVar(servo, val);
  val = 0;
  UBindFunctions(servo, last, mates);
  URegister(servohub);
  USetUpdate(1);
}

int servo::update()
{
  ((servohub*) getUObjectHub("servohub"))->addValue(id_, (double) val);
  return 0;
}

std::string servo::last()
{
  std::ostringstream out;
  for (const auto& each : commanded)
    out << (out.tellp() > 0 ? " " : "") << each.first << ":" << each.second;
  return out.str();
}

int servo::mates()
{
  int count = 0;
  for (UObjectList::iterator i = objecthub->members.begin(); i != objecthub->members.end(); ++i)
    if (((servo*) *i)->classname == "servo")
      ++count;
  return count;
}

UStart(servo);
