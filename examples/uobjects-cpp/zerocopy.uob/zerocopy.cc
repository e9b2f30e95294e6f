#include <cstring>

#include <urbi/uobject.hh>

using namespace urbi;

/// Where the last image was, to show that none was copied.
static const void* source = 0;

/// Makes images that nobody copies.
class OptimizedImageSource : public UObject
{
public:
  OptimizedImageSource(const std::string& s)
    : UObject(s)
  {
    UBindFunction(OptimizedImageSource, init);
  }

  void init();
  virtual int update();

  UVar val;
  UBinary imageData;
};

void OptimizedImageSource::init()
{
  UBindVar(OptimizedImageSource, val);
  val.setBypass(true);
  imageData.type = BINARY_IMAGE;
  imageData.image.imageFormat = IMAGE_RGB;
  imageData.image.width = 640;
  imageData.image.height = 480;
  imageData.image.size = 640 * 480 * 3;
  imageData.image.data = static_cast<unsigned char*>(malloc(imageData.image.size));
  memset(imageData.image.data, 'x', imageData.image.size);
  source = imageData.image.data;
  USetUpdate(10);
}

int OptimizedImageSource::update()
{
  val = imageData;
  return 0;
}

/// Looks at them where they are.
class BinaryProcessor : public UObject
{
public:
  BinaryProcessor(const std::string& s)
    : UObject(s)
  {
    UBindFunction(BinaryProcessor, init);
  }

  void init();
  void onData(UVar& v);

  InputPort binaryIn;
  UVar same;
  UVar size;
};

void BinaryProcessor::init()
{
  UBindVar(BinaryProcessor, binaryIn);
  UBindVars(BinaryProcessor, same, size);
  UNotifyChange(binaryIn, &BinaryProcessor::onData);
}

void BinaryProcessor::onData(UVar& v)
{
  const UBinary& b = v;
  same = b.common.data == source;
  size = b.common.size;
}

UStart(OptimizedImageSource);
UStart(BinaryProcessor);
