// What bench/native measures.
#include <cstdlib>

#include <urbi/uobject.hh>

using namespace urbi;

/// Calls, changes and images cross the boundary by it.
class Crossings : public UObject
{
public:
  Crossings(const std::string& s)
    : UObject(s)
  {
    UBindFunctions(Crossings, next, images);
    UBindVars(Crossings, watched, image, input);
    UNotifyChange(watched, &Crossings::changed);
    image.setBypass(true);
    binary.type = BINARY_IMAGE;
    binary.image.imageFormat = IMAGE_RGB;
    binary.image.width = 640;
    binary.image.height = 480;
    binary.image.size = 640 * 480 * 3;
    binary.image.data = static_cast<unsigned char*>(calloc(binary.image.size, 1));
    UNotifyChange(input, &Crossings::received);
  }

  double next(double x)
  {
    return x + 1;
  }

  void changed(double x)
  {
    last = x;
  }

  /// Hands the image over so many times; how many of them came without a copy.
  int images(int count)
  {
    same = 0;
    for (int i = 0; i < count; ++i)
      image = binary;
    return same;
  }

  void received(UVar& v)
  {
    const UBinary& b = v;
    same += b.common.data == binary.common.data;
  }

  UVar watched;
  UVar image;
  InputPort input;
  UBinary binary;
  double last = 0;
  int same = 0;
};

UStart(Crossings);

extern "C" int bare_call(int x)
{
  return x + 1;
}

extern "C" int bare_callbacks(int (*function)(int), int count)
{
  int x = 0;
  for (int i = 0; i < count; ++i)
    x = function(x);
  return x;
}
