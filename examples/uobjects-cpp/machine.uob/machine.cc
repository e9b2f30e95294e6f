#include "machine.hh"

#include <chrono>
#include <thread>

Machine::Machine(double d)
  : duration(d)
{}

std::string Machine::operator()(const std::list<std::string>& parts) const
{
  std::this_thread::sleep_for(std::chrono::duration<double>(duration));
  std::string whole;
  for (const std::string& part : parts)
    whole += part;
  return whole;
}
