#include <urbi/uobject.hh>

#include <urbi/uconversion.hh>

using namespace urbi;

/// Works on sounds of 8 bits and one channel, whatever it gets.
class SoundAlgorithm : public UObject
{
public:
  SoundAlgorithm(const std::string& s)
    : UObject(s)
  {
    UBindFunction(SoundAlgorithm, init);
  }

  ~SoundAlgorithm() override
  {
    free(convertedData.data);
  }

  void init(UVar& dataSource);
  void onData(UVar& v);

  /// Used again and again.
  USound convertedData;
  UVar samples;
  UVar loudest;
};

void SoundAlgorithm::init(UVar& dataSource)
{
  convertedData.data = 0;
  convertedData.size = 0; // Let convert allocate for us.
  convertedData.soundFormat = SOUND_RAW;
  convertedData.channels = 1;
  convertedData.rate = 0; // That of the source.
  convertedData.sampleSize = 8;
  convertedData.sampleFormat = SAMPLE_UNSIGNED;
  UBindVars(SoundAlgorithm, samples, loudest);
  samples = loudest = 0;
  UNotifyChange(dataSource, &SoundAlgorithm::onData);
}

void SoundAlgorithm::onData(UVar& v)
{
  USound src = v;
  convert(src, convertedData);
  int most = 0;
  for (size_t i = 0; i < convertedData.size; ++i)
    if (static_cast<unsigned char>(convertedData.data[i]) > most)
      most = static_cast<unsigned char>(convertedData.data[i]);
  samples = convertedData.size;
  loudest = most;
}

UStart(SoundAlgorithm);

/// A microphone that hears what it is told: stereo, 16 bits.
class Micro : public UObject
{
public:
  Micro(const std::string& s)
    : UObject(s)
  {
    UBindVar(Micro, val);
    UBindFunction(Micro, hear);
  }

  void hear(const std::vector<short>& samples)
  {
    USound sound;
    sound.soundFormat = SOUND_RAW;
    sound.channels = 2;
    sound.rate = 8000;
    sound.sampleSize = 16;
    sound.sampleFormat = SAMPLE_SIGNED;
    sound.data = reinterpret_cast<char*>(const_cast<short*>(samples.data()));
    sound.size = samples.size() * sizeof(short);
    val = sound;
  }

  UVar val;
};

UStart(Micro);
