/// What urbi/ucontext.hh and urbi/ucontext-impl.hh declare: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/ucontext.hh>

#ifndef URBI_DETAIL_CODE_UCONTEXT_HH
#define URBI_DETAIL_CODE_UCONTEXT_HH

#include <cctype>

#include <unistd.h>

namespace urbi
{
  namespace detail
  {
    URBI_INLINE void send_text(int64_t context, const std::string& code)
    {
      Request request(URBI_SEND, context);
      request.out.text(code);
      request.send();
    }

    URBI_INLINE UObjectMode loading_mode()
    {
      Dl_info found;
      if (!dladdr(reinterpret_cast<void*>(&module), &found) || !found.dli_fname)
        return MODE_REMOTE;
      std::string path(found.dli_fname);
      size_t dots = 0;
      for (size_t at = path.find("/./"); at != std::string::npos; at = path.find("/./", at + 2))
        ++dots;
      return dots % 2 ? MODE_PLUGIN : MODE_REMOTE;
    }

    URBI_INLINE UObjectMode running_mode(int64_t context)
    {
      if (!context || !module().host)
        return loading_mode();
      return static_cast<UObjectMode>(Request(URBI_MODE, context).send());
    }

    URBI_INLINE void yield_for(int64_t context, libport::utime_t microseconds)
    {
      Request request(URBI_YIELD, context);
      request.out.raw(static_cast<int64_t>(microseconds < 0 ? 0 : microseconds));
      request.send();
    }

    URBI_INLINE bool server(int64_t context, std::string& host, unsigned& port)
    {
      if (!context || !module().host)
        return false;
      Request request(URBI_SERVER, context);
      port = static_cast<unsigned>(request.send());
      if (port)
        host = request.reply().text();
      return port;
    }

    URBI_STATE Contexts& contexts()
    {
      static Contexts all;
      return all;
    }

    URBI_INLINE impl::UContextImpl* find_context(int64_t number)
    {
      for (impl::UContextImpl* each = contexts().first; each; each = each->next)
        if (each->number() == number)
          return each;
      return nullptr;
    }

    URBI_INLINE impl::UContextImpl* context_of(int64_t number)
    {
      if (!number)
        return nullptr;
      if (impl::UContextImpl* found = find_context(number))
        return found;
      std::lock_guard<std::mutex> guard(contexts().adding);
      if (impl::UContextImpl* found = find_context(number))
        return found;
      impl::UContextImpl* made = new impl::UContextImpl(number);
      made->next = contexts().first;
      contexts().first = made;
      return made;
    }

    URBI_INLINE SendBuffer::~SendBuffer()
    {
      sync();
    }

    URBI_INLINE int SendBuffer::sync()
    {
      std::string code = str();
      if (code.empty())
        return 0;
      str("");
      try
      {
        send_text(context ? context : current_context(), code);
      }
      catch (const std::exception&)
      {
        return -1;
      }
      return 0;
    }

    URBI_INLINE SendStream::SendStream(int64_t in)
      : std::ostream(static_cast<SendBuffer*>(this))
    {
      context = in;
    }

    URBI_INLINE SendStream::SendStream(SendStream&& other)
      : SendStream(other.context)
    {}

    URBI_INLINE std::string formatted(const char* format, va_list arguments)
    {
      va_list again;
      va_copy(again, arguments);
      int length = std::vsnprintf(nullptr, 0, format, again);
      va_end(again);
      std::string text(length < 0 ? 0 : static_cast<size_t>(length), '\0');
      std::vsnprintf(&text[0], text.size() + 1, format, arguments);
      return text;
    }

    URBI_INLINE std::string unarmored(const char* armored)
    {
      std::string code(armored);
      size_t begin = code.find_first_not_of(" \t\n");
      size_t end = code.find_last_not_of(" \t\n");
      if (begin == std::string::npos)
        return "";
      if (code[begin] == '(' && code[end] == ')')
        return code.substr(begin + 1, end - begin - 1);
      return code.substr(begin, end - begin + 1);
    }
  }

  URBI_INLINE void UContext::send(const char* code) const
  {
    send(std::string(code));
  }

  URBI_INLINE void UContext::send(const void* code, size_t size) const
  {
    send(std::string(static_cast<const char*>(code), size));
  }

  URBI_INLINE void UContext::setThreadLimit(size_t threads) const
  {
    detail::Request request(URBI_THREAD_LIMIT, context());
    request.out.raw(static_cast<int64_t>(threads));
    request.send();
  }

  URBI_INLINE detail::SendStream UContext::uobject_unarmorAndSend(const char* armored) const
  {
    std::string code = detail::unarmored(armored);
    if (!code.empty())
      send(code);
    return detail::SendStream(context());
  }

  URBI_INLINE impl::UContextImpl* getCurrentContext()
  {
    return detail::context_of(detail::current_context());
  }

  URBI_INLINE void setCurrentContext(impl::UContextImpl* context)
  {
    detail::thread_state().context = context ? context->number() : 0;
  }

  URBI_INLINE void send(const std::string& code)
  {
    detail::send_text(detail::current_context(), code);
  }

  URBI_INLINE void send(const void* code, size_t size)
  {
    send(std::string(static_cast<const char*>(code), size));
  }

  URBI_INLINE detail::SendStream uobject_unarmorAndSend(const char* armored)
  {
    std::string code = detail::unarmored(armored);
    if (!code.empty())
      send(code);
    return detail::SendStream(detail::current_context());
  }

  URBI_INLINE void echo(const char* format, ...)
  {
    va_list arguments;
    va_start(arguments, format);
    std::string text = detail::formatted(format, arguments);
    va_end(arguments);
    detail::Request request(URBI_REPORT, detail::current_context());
    request.out.text(text);
    request.send();
  }

  URBI_INLINE std::string getFilteredHostname()
  {
    char name[256] = "";
    ::gethostname(name, sizeof name - 1);
    std::string filtered(name);
    for (char& each : filtered)
      if (!std::isalnum(static_cast<unsigned char>(each)))
        each = '_';
    return filtered;
  }

  URBI_INLINE void setThreadLimit(size_t threads)
  {
    detail::Request request(URBI_THREAD_LIMIT, detail::current_context());
    request.out.raw(static_cast<int64_t>(threads));
    request.send();
  }
}

#endif
