#include <urbi/uobject.hh>

namespace
{
  /// The first pixel that is brighter than 200.
  bool detectBall(unsigned char* data, size_t width, size_t height, int* x, int* y)
  {
    for (size_t i = 0; i < width * height; ++i)
      if (data[i] > 200)
      {
        *x = static_cast<int>(i % width);
        *y = static_cast<int>(i / width);
        return true;
      }
    return false;
  }
}

/// Gives out images with a bright pixel.
class Painter : public urbi::UObject
{
public:
  Painter(const std::string& s)
    : urbi::UObject(s)
  {
    UBindVar(Painter, val);
    UBindFunctions(Painter, paint, clear);
  }

  void paint(int x, int y)
  {
    unsigned char pixels[8 * 4] = {0};
    pixels[y * 8 + x] = 255;
    publish(pixels);
  }

  void clear()
  {
    unsigned char pixels[8 * 4] = {0};
    publish(pixels);
  }

  void publish(unsigned char* pixels)
  {
    UImage image;
    image.imageFormat = IMAGE_GREY8;
    image.width = 8;
    image.height = 4;
    image.size = 8 * 4;
    image.data = pixels;
    val = image;
  }

  urbi::UVar val;
};
UStart(Painter);

/// Finds a ball in the images of a variable of that name.
class BallTracker : public urbi::UObject
{
public:
  BallTracker(const std::string&);
  void init(const std::string& varname);

  urbi::UVar visible;
  urbi::UVar x;
  urbi::UVar y;

  void newImage(urbi::UVar& v);
};

BallTracker::BallTracker(const std::string& s)
  : urbi::UObject(s)
{
  UBindFunction(BallTracker, init);
}

void BallTracker::init(const std::string& cameraval)
{
  UBindVar(BallTracker, visible);
  UBindVar(BallTracker, x);
  UBindVar(BallTracker, y);
  UNotifyChange(cameraval, &BallTracker::newImage);

  visible = x = y = 0;
}

void BallTracker::newImage(urbi::UVar& v)
{
  urbi::UImage i = v;
  int px, py;
  bool found = detectBall(i.data, i.width, i.height, &px, &py);
  if (found)
  {
    visible = 1;
    x = static_cast<double>(px) / static_cast<double>(i.width);
    y = static_cast<double>(py) / static_cast<double>(i.height);
  }
  else
    visible = 0;
}

UStart(BallTracker);

/// The same, from a variable that is given to its constructor.
class ObjectTracker : public urbi::UObject
{
public:
  ObjectTracker(const std::string& n)
    : urbi::UObject(n)
  {
    UBindFunction(ObjectTracker, init);
  }

  void init(UVar& image)
  {
    UNotifyChange(image, &ObjectTracker::onImage);
    UBindVar(ObjectTracker, val);
    val = 0;
  }

  void onImage(UVar& src)
  {
    UBinary b = src;
    int px = 0, py = 0;
    bool found = detectBall(b.image.data, b.image.width, b.image.height, &px, &py);
    val = found ? px : -1;
  }

  UVar val;
};
UStart(ObjectTracker);

/// The same, from whatever is led into its port.
class PortTracker : public urbi::UObject
{
public:
  PortTracker(const std::string& n)
    : urbi::UObject(n)
  {
    UBindFunction(PortTracker, init);
    UBindVar(PortTracker, input);
    UBindVar(PortTracker, val);
    val = 0;
    UNotifyChange(input, &PortTracker::onImage);
  }

  void init()
  {}

  void onImage(UVar& src)
  {
    UBinary b = src;
    val = static_cast<double>(b.image.width);
  }

  UVar val;
  InputPort input;
};
UStart(PortTracker);
