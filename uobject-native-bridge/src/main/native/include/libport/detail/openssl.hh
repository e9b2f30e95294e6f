/// The functions of OpenSSL that TLS needs, without its headers, and without linking with it.
#ifndef LIBPORT_DETAIL_OPENSSL_HH
#define LIBPORT_DETAIL_OPENSSL_HH

#include <stdexcept>
#include <string>

#include <dlfcn.h>

namespace libport
{
  namespace detail
  {
    /// OpenSSL as the system has it, version 3 or 1.1.1. Programs that do not use TLS do not need it.
    class OpenSsl
    {
    public:
      enum Constant
      {
        VERIFY_PEER = 1,
        SET_HOST_NAME = 55,
        SET_LEAST_VERSION = 123,
        TLS_1_3 = 0x0304,
        PARTIAL_CHAIN = 0x80000,
        ERROR_WANT_READ = 2,
        ERROR_ZERO_RETURN = 6,
        NOT_YET_VALID = 9,
        EXPIRED = 10,
        OTHER_NAME = 62,
        OTHER_ADDRESS = 64,
      };

      /// \throw std::runtime_error if the system has none
      static const OpenSsl& get()
      {
        static const OpenSsl own;
        return own;
      }

      void* (*TLS_client_method)();
      void* (*SSL_CTX_new)(void*);
      void (*SSL_CTX_free)(void*);
      int (*SSL_CTX_set_default_verify_paths)(void*);
      int (*SSL_CTX_load_verify_locations)(void*, const char*, const char*);
      void* (*SSL_new)(void*);
      void (*SSL_free)(void*);
      void (*SSL_set_bio)(void*, void*, void*);
      void (*SSL_set_verify)(void*, int, void*);
      void (*SSL_set_connect_state)(void*);
      long (*SSL_ctrl)(void*, int, long, void*);
      int (*SSL_set1_host)(void*, const char*);
      void* (*SSL_get0_param)(void*);
      int (*SSL_do_handshake)(void*);
      int (*SSL_read)(void*, void*, int);
      int (*SSL_write)(void*, const void*, int);
      int (*SSL_shutdown)(void*);
      int (*SSL_get_error)(const void*, int);
      long (*SSL_get_verify_result)(const void*);
      int (*X509_VERIFY_PARAM_set_flags)(void*, unsigned long);
      int (*X509_VERIFY_PARAM_set1_ip_asc)(void*, const char*);
      const char* (*X509_verify_cert_error_string)(long);
      void* (*BIO_new)(const void*);
      const void* (*BIO_s_mem)();
      int (*BIO_read)(void*, void*, int);
      int (*BIO_write)(void*, const void*, int);
      void (*ERR_clear_error)();
      unsigned long (*ERR_get_error)();
      const char* (*ERR_reason_error_string)(unsigned long);

    private:
      OpenSsl()
      {
        void* library = nullptr;
        for (const char* name : {"libssl.so.3", "libssl.so.1.1", "libssl.3.dylib"})
          if (!library)
            library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (!library)
          throw std::runtime_error("TLS needs OpenSSL (libssl.so.3), which is not installed");
#define LIBPORT_OPENSSL_(Name) find(library, #Name, Name)
        LIBPORT_OPENSSL_(TLS_client_method);
        LIBPORT_OPENSSL_(SSL_CTX_new);
        LIBPORT_OPENSSL_(SSL_CTX_free);
        LIBPORT_OPENSSL_(SSL_CTX_set_default_verify_paths);
        LIBPORT_OPENSSL_(SSL_CTX_load_verify_locations);
        LIBPORT_OPENSSL_(SSL_new);
        LIBPORT_OPENSSL_(SSL_free);
        LIBPORT_OPENSSL_(SSL_set_bio);
        LIBPORT_OPENSSL_(SSL_set_verify);
        LIBPORT_OPENSSL_(SSL_set_connect_state);
        LIBPORT_OPENSSL_(SSL_ctrl);
        LIBPORT_OPENSSL_(SSL_set1_host);
        LIBPORT_OPENSSL_(SSL_get0_param);
        LIBPORT_OPENSSL_(SSL_do_handshake);
        LIBPORT_OPENSSL_(SSL_read);
        LIBPORT_OPENSSL_(SSL_write);
        LIBPORT_OPENSSL_(SSL_shutdown);
        LIBPORT_OPENSSL_(SSL_get_error);
        LIBPORT_OPENSSL_(SSL_get_verify_result);
        LIBPORT_OPENSSL_(X509_VERIFY_PARAM_set_flags);
        LIBPORT_OPENSSL_(X509_VERIFY_PARAM_set1_ip_asc);
        LIBPORT_OPENSSL_(X509_verify_cert_error_string);
        LIBPORT_OPENSSL_(BIO_new);
        LIBPORT_OPENSSL_(BIO_s_mem);
        LIBPORT_OPENSSL_(BIO_read);
        LIBPORT_OPENSSL_(BIO_write);
        LIBPORT_OPENSSL_(ERR_clear_error);
        LIBPORT_OPENSSL_(ERR_get_error);
        LIBPORT_OPENSSL_(ERR_reason_error_string);
#undef LIBPORT_OPENSSL_
      }

      template <typename Function>
      static void find(void* library, const char* name, Function& function)
      {
        function = reinterpret_cast<Function>(dlsym(library, name));
        if (!function)
          throw std::runtime_error(std::string("TLS needs a newer OpenSSL: there is no ") + name);
      }
    };
  }
}

#endif
