/// Messages of a server.
#ifndef URBI_UMESSAGE_HH
#define URBI_UMESSAGE_HH

#include <memory>
#include <ostream>
#include <string>

#include <urbi/uvalue.hh>

namespace urbi
{
  enum UMessageType
  {
    MESSAGE_SYSTEM, ///< begins with ***
    MESSAGE_ERROR,  ///< begins with !!!
    MESSAGE_DATA,   ///< anything else
  };

  /// What a server has sent: `[timestamp:tag] message`.
  class UMessage
  {
  public:
    /// \param text  what follows the time stamp; data of binaries follow their headers
    UMessage(UAbstractClient& from, int time, const std::string& channel, const std::string& text)
      : client(from)
      , timestamp(time)
      , tag(channel)
      , type(MESSAGE_DATA)
      , value(nullptr)
      , message(text)
      , rawMessage(text)
    {
      if (text.compare(0, 3, "***") == 0 || text.compare(0, 3, "!!!") == 0)
      {
        type = text[0] == '*' ? MESSAGE_SYSTEM : MESSAGE_ERROR;
        message = text.substr(text.size() > 3 && text[3] == ' ' ? 4 : 3);
        return;
      }
      UValue read;
      if (detail::read_literal(text, read))
        value = new UValue(std::move(read));
    }

    explicit UMessage(UAbstractClient& from)
      : UMessage(from, 0, "", "")
    {}

    UMessage(const UMessage& other)
      : client(other.client)
      , timestamp(other.timestamp)
      , tag(other.tag)
      , type(other.type)
      , value(other.value ? new UValue(*other.value) : nullptr)
      , message(other.message)
      , rawMessage(other.rawMessage)
    {}

    UMessage& operator=(const UMessage&) = delete;

    ~UMessage()
    {
      delete value;
    }

    /// \throw std::runtime_error if the message is no value
    operator UValue&() const
    {
      if (!value)
        throw std::runtime_error("the message is no value: " + rawMessage);
      return *value;
    }

    std::ostream& print(std::ostream& out) const
    {
      return out << "[" << timestamp << (tag.empty() ? "" : ":" + tag) << "] " << rawMessage;
    }

    UAbstractClient& client;
    int timestamp; ///< in milliseconds
    std::string tag;
    UMessageType type;
    UValue* value; ///< null if it is none
    std::string message;
    std::string rawMessage;
  };

  inline std::ostream& operator<<(std::ostream& out, const UMessage& message)
  {
    return message.print(out);
  }

  /// Takes the value of a message, which is deleted; 0 if it had none, or one of another kind.
  template <typename T>
  int getValue(UMessage* message, T& out)
  {
    std::unique_ptr<UMessage> owner(message);
    if (!message || !message->value)
      return 0;
    try
    {
      out = uvalue_cast<T>(*message->value);
    }
    catch (const std::exception&)
    {
      return 0;
    }
    return 1;
  }
}

#endif
