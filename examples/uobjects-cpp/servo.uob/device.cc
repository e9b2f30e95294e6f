#include "device.hh"

#include <map>

namespace
{
  struct Motor
  {
    double position = 0;
    int gains = 0;
  };

  std::map<int, Motor> motors;
}

bool initialize(int id)
{
  if (id < 0)
    return false;
  motors[id] = Motor();
  return true;
}

double getPosition(int id)
{
  return motors[id].position;
}

void setPosition(int id, double pos)
{
  motors[id].position += (pos - motors[id].position) / 2;
}

void setPID(int id, int p, int i, int d)
{
  motors[id].gains = p * 100 + i * 10 + d;
}

int gains(int id)
{
  return motors[id].gains;
}
