/// TLS to a server, whose certificate must be for the name that was asked for.
#ifndef LIBPORT_DETAIL_TLS_HH
#define LIBPORT_DETAIL_TLS_HH

#include <cerrno>
#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <string>
#include <strings.h>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <libport/detail/openssl.hh>

namespace libport
{
  namespace detail
  {
    /// What the environment says of TLS.
    struct TlsSettings
    {
      /// Whether clients are to use it.
      static bool wanted()
      {
        const char* text = std::getenv("URBI_TLS");
        if (!text)
          return trusted() != nullptr;
        for (const char* no : {"", "0", "no", "false", "off"})
          if (strcasecmp(text, no) == 0)
            return false;
        return true;
      }

      /// The file of the certificates that are trusted; null for those that the system trusts.
      static const char* trusted()
      {
        const char* file = std::getenv("URBI_TLS_CA");
        return file && *file ? file : nullptr;
      }
    };

    /// What goes over one connected socket. One thread receives, while any number of others send.
    class Tls
    {
    public:
      /// Shakes hands.
      /// \throw std::runtime_error that says what is wrong, and what to do
      Tls(int socket, const std::string& host)
        : ssl_(OpenSsl::get())
        , socket_(socket)
        , context_(ssl_.SSL_CTX_new(ssl_.TLS_client_method()))
        , session_(nullptr)
      {
        try
        {
          trust();
          session_ = ssl_.SSL_new(context_);
          in_ = ssl_.BIO_new(ssl_.BIO_s_mem());
          out_ = ssl_.BIO_new(ssl_.BIO_s_mem());
          ssl_.SSL_set_bio(session_, in_, out_);
          ssl_.SSL_ctrl(session_, OpenSsl::SET_LEAST_VERSION, OpenSsl::TLS_1_3, nullptr);
          ssl_.SSL_set_verify(session_, OpenSsl::VERIFY_PEER, nullptr);
          expect(host);
          ssl_.SSL_set_connect_state(session_);
          setReceiveLimit(HANDSHAKE_SECONDS);
          shakeHands();
          setReceiveLimit(0);
        }
        catch (...)
        {
          release();
          throw;
        }
      }

      ~Tls()
      {
        release();
      }

      Tls(const Tls&) = delete;
      Tls& operator=(const Tls&) = delete;

      /// Sends all of it. \return whether that went well
      bool send(const char* data, size_t length)
      {
        std::lock_guard<std::mutex> sending(sending_);
        while (length)
        {
          int part = static_cast<int>(length < PART ? length : PART);
          std::string encrypted;
          {
            std::lock_guard<std::mutex> guard(lock_);
            ssl_.ERR_clear_error();
            if (ssl_.SSL_write(session_, data, part) != part)
              return false;
            encrypted = pending();
          }
          if (!transmit(encrypted))
            return false;
          data += part;
          length -= static_cast<size_t>(part);
        }
        return true;
      }

      /// \return how many bytes have come; 0 at the end, -1 if the connection is lost
      ssize_t receive(char* data, size_t length)
      {
        for (;;)
        {
          {
            std::lock_guard<std::mutex> guard(lock_);
            ssl_.ERR_clear_error();
            int size = ssl_.SSL_read(session_, data, static_cast<int>(length));
            if (size > 0)
              return size;
            int error = ssl_.SSL_get_error(session_, size);
            if (error == OpenSsl::ERROR_ZERO_RETURN)
              return 0;
            if (error != OpenSsl::ERROR_WANT_READ)
              return -1;
          }
          if (fetch() <= 0)
            return -1;
        }
      }

      /// Tells the server that nothing more comes: otherwise it takes the connection for cut.
      void endOutput()
      {
        std::lock_guard<std::mutex> sending(sending_);
        std::string last;
        {
          std::lock_guard<std::mutex> guard(lock_);
          ssl_.ERR_clear_error();
          ssl_.SSL_shutdown(session_);
          last = pending();
        }
        // Who closes does not wait for a server that does not read.
        ::send(socket_, last.data(), last.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      }

    private:
      static const int HANDSHAKE_SECONDS = 10;
      static const size_t PART = 1 << 20;

      void release()
      {
        if (session_)
          ssl_.SSL_free(session_);
        ssl_.SSL_CTX_free(context_);
      }

      void trust()
      {
        const char* file = TlsSettings::trusted();
        if (!file)
          ssl_.SSL_CTX_set_default_verify_paths(context_);
        else if (ssl_.SSL_CTX_load_verify_locations(context_, file, nullptr) != 1)
          throw std::runtime_error(std::string("cannot read the certificate to be trusted, ") + file);
      }

      /// The name or the address that the certificate has to be for.
      void expect(const std::string& host)
      {
        void* terms = ssl_.SSL_get0_param(session_);
        // The server's own certificate may be trusted without that of who has signed it.
        ssl_.X509_VERIFY_PARAM_set_flags(terms, OpenSsl::PARTIAL_CHAIN);
        in6_addr address;
        if (inet_pton(AF_INET, host.c_str(), &address) == 1
            || inet_pton(AF_INET6, host.c_str(), &address) == 1)
        {
          ssl_.X509_VERIFY_PARAM_set1_ip_asc(terms, host.c_str());
          return;
        }
        ssl_.SSL_set1_host(session_, host.c_str());
        ssl_.SSL_ctrl(session_, OpenSsl::SET_HOST_NAME, 0, const_cast<char*>(host.c_str()));
      }

      void setReceiveLimit(int seconds)
      {
        timeval limit = {seconds, 0};
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
      }

      void shakeHands()
      {
        for (;;)
        {
          ssl_.ERR_clear_error();
          int done = ssl_.SSL_do_handshake(session_);
          int error = ssl_.SSL_get_error(session_, done);
          transmit(pending());
          if (done == 1)
            return;
          if (error != OpenSsl::ERROR_WANT_READ)
            throw std::runtime_error(refusal());
          ssize_t size = fetch();
          if (size == 0)
            throw std::runtime_error("the server has closed the connection: does it speak TLS?");
          if (size < 0)
            throw std::runtime_error("no answer in TLS: does the server speak it?");
        }
      }

      std::string refusal()
      {
        long verified = ssl_.SSL_get_verify_result(session_);
        switch (verified)
        {
        case 0:
          break;
        case OpenSsl::EXPIRED:
          return "the server's certificate has expired, it needs a new one";
        case OpenSsl::NOT_YET_VALID:
          return "the server's certificate is not valid yet: is the clock right?";
        case OpenSsl::OTHER_NAME:
        case OpenSsl::OTHER_ADDRESS:
          return "the server's certificate is for another name";
        default:
          return std::string("the server's certificate is not trusted: if it is the right server,"
                             " give its certificate by URBI_TLS_CA (")
                 + ssl_.X509_verify_cert_error_string(verified) + ")";
        }
        const char* reason = ssl_.ERR_reason_error_string(ssl_.ERR_get_error());
        return std::string("the server has not answered in TLS: it does not speak it, or has no place"
                           " for another client (")
               + (reason ? reason : "unknown") + ")";
      }

      /// What is encrypted and not sent yet.
      std::string pending()
      {
        std::string all;
        char buffer[16384];
        for (int size; (size = ssl_.BIO_read(out_, buffer, sizeof buffer)) > 0;)
          all.append(buffer, static_cast<size_t>(size));
        return all;
      }

      bool transmit(const std::string& encrypted)
      {
        for (size_t done = 0; done < encrypted.size();)
        {
          ssize_t sent =
            ::send(socket_, encrypted.data() + done, encrypted.size() - done, MSG_NOSIGNAL);
          if (sent < 0 && errno == EINTR)
            continue;
          if (sent < 0)
            return false;
          done += static_cast<size_t>(sent);
        }
        return true;
      }

      /// Takes what has come, encrypted. \return as `recv`
      ssize_t fetch()
      {
        char buffer[16384];
        ssize_t size;
        do
          size = ::recv(socket_, buffer, sizeof buffer, 0);
        while (size < 0 && errno == EINTR);
        if (size > 0)
        {
          std::lock_guard<std::mutex> guard(lock_);
          ssl_.BIO_write(in_, buffer, static_cast<int>(size));
        }
        return size;
      }

      const OpenSsl& ssl_;
      int socket_;
      void* context_;
      void* session_;
      void* in_;
      void* out_;
      std::mutex sending_;
      std::mutex lock_;
    };
  }
}

#endif
