#include <stdexcept>
#include <vector>

#include <urbi/uobject.hh>

namespace
{
  const int WIDTH = 4;
  const int HEIGHT = 2;

  std::vector<unsigned char> buffer(WIDTH* HEIGHT * 3);
  int taken = 0;

  bool initialize(int id)
  {
    return id == 0;
  }

  int getWidth(int)
  {
    return WIDTH;
  }

  int getHeight(int)
  {
    return HEIGHT;
  }

  /// The number of the image, in each of its bytes.
  unsigned char* getImage(int)
  {
    ++taken;
    for (unsigned char& byte : buffer)
      byte = static_cast<unsigned char>('a' + taken % 26);
    return buffer.data();
  }
}

/// A camera, which takes an image when one is wanted.
class Camera : public urbi::UObject
{
public:
  Camera(const std::string&);
  ~Camera() override;

  void init(int id);

  urbi::UVar val;
  urbi::UVar width;
  urbi::UVar height;

  void getVal(UVar&);
  virtual int update();

  int frame;
  int accessFrame;
  int id_;
  UBinary bin;
};

Camera::Camera(const std::string& s)
  : urbi::UObject(s)
  , frame(0)
  , accessFrame(-1)
  , id_(0)
{
  UBindFunction(Camera, init);
}

Camera::~Camera()
{
  // The buffer belongs to the device.
  bin.image.data = 0;
}

void Camera::init(int id)
{
  id_ = id;
  frame = 0;
  accessFrame = -1;

  if (!initialize(id))
    throw std::runtime_error("Failed to initialize camera");

  UBindVar(Camera, val);
  UBindVar(Camera, width);
  UBindVar(Camera, height);
  width = getWidth(id);
  height = getHeight(id);

  UNotifyAccess(val, &Camera::getVal);

  bin.type = BINARY_IMAGE;
  bin.image.width = width;
  bin.image.height = height;
  bin.image.imageFormat = IMAGE_RGB;
  bin.image.size = width * height * 3;

  USetUpdate(1);
}

int Camera::update()
{
  ++frame;
  return 0;
}

void Camera::getVal(urbi::UVar&)
{
  if (frame == accessFrame)
    return;
  accessFrame = frame;

  bin.image.data = getImage(id_);
  val = bin;
}

UStart(Camera);
