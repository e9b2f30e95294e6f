/// A Java virtual machine inside a program of C++, in which the rest of Urbi runs.
#ifndef URBI_DETAIL_JAVA_MACHINE_HH
#define URBI_DETAIL_JAVA_MACHINE_HH

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>

#include <urbi/export.hh>

namespace urbi
{
  namespace detail
  {
    /// What the Java Native Interface gives to C, without its header: tables of functions whose places
    /// its specification fixes (chapters "Interface Function Table" and "The Invocation API").
    namespace jni
    {
      enum Version
      {
        VERSION = 0x00010008,
      };

      enum MachineFunction
      {
        ATTACH_CURRENT_THREAD = 4,
      };

      enum Function
      {
        FIND_CLASS = 6,
        EXCEPTION_DESCRIBE = 16,
        GET_STATIC_METHOD_ID = 113,
        CALL_STATIC_INT_METHOD_A = 131,
        NEW_STRING_UTF = 167,
        NEW_OBJECT_ARRAY = 172,
        SET_OBJECT_ARRAY_ELEMENT = 174,
        EXCEPTION_CHECK = 228,
      };

      typedef void* Object;
      typedef void** const* Env;
      typedef void** const* Machine;

      struct Option
      {
        const char* text;
        void* extra;
      };

      struct MachineArguments
      {
        int32_t version;
        int32_t count;
        Option* options;
        uint8_t ignoreUnrecognized;
      };

      union Value
      {
        uint8_t z;
        int64_t j;
        double d;
        Object l;
      };
    }

    class JavaMachine
    {
    public:
      /// The machine of this process. It is started when it is wanted for the first time.
      /// \param root the folder in which Urbi is
      /// \throw std::runtime_error
      URBI_LOCAL static JavaMachine& of(const std::string& root)
      {
        // It lives as long as the process.
        static JavaMachine* only = new JavaMachine(root);
        return *only;
      }

      /// Calls a static function of Java that takes texts, and a number, and returns a number.
      int call(const std::string& className, const std::string& method,
               const std::vector<std::string>& texts, bool flag)
      {
        env_ = nullptr;
        machine_function<int (*)(jni::Machine, jni::Env*, void*)>(jni::ATTACH_CURRENT_THREAD)(
          machine_, &env_, nullptr);
        jni::Object type = found(function<jni::Object (*)(jni::Env, const char*)>(jni::FIND_CLASS)(
          env_, className.c_str()));
        jni::Object called =
          found(function<jni::Object (*)(jni::Env, jni::Object, const char*, const char*)>(
            jni::GET_STATIC_METHOD_ID)(env_, type, method.c_str(), "([Ljava/lang/String;Z)I"));
        jni::Object textType = found(
          function<jni::Object (*)(jni::Env, const char*)>(jni::FIND_CLASS)(env_, "java/lang/String"));
        jni::Object array =
          found(function<jni::Object (*)(jni::Env, int32_t, jni::Object, jni::Object)>(
            jni::NEW_OBJECT_ARRAY)(env_, static_cast<int32_t>(texts.size()), textType, nullptr));
        for (size_t i = 0; i < texts.size(); ++i)
        {
          jni::Object text = found(function<jni::Object (*)(jni::Env, const char*)>(
            jni::NEW_STRING_UTF)(env_, texts[i].c_str()));
          function<void (*)(jni::Env, jni::Object, int32_t, jni::Object)>(
            jni::SET_OBJECT_ARRAY_ELEMENT)(env_, array, static_cast<int32_t>(i), text);
        }
        jni::Value arguments[2];
        arguments[0].l = array;
        arguments[1].j = 0;
        arguments[1].z = flag;
        int32_t result =
          function<int32_t (*)(jni::Env, jni::Object, jni::Object, const jni::Value*)>(
            jni::CALL_STATIC_INT_METHOD_A)(env_, type, called, arguments);
        check();
        return result;
      }

    private:
      explicit JavaMachine(const std::string& root)
        : machine_(nullptr)
        , env_(nullptr)
      {
        std::vector<std::string> words = command(root);
        std::string library = words[0].substr(0, words[0].rfind("/bin/")) + "/lib/server/libjvm.so";
        void* loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL);
        if (!loaded)
          throw std::runtime_error(std::string("cannot load Java: ") + dlerror());
        typedef int (*Create)(jni::Machine*, jni::Env*, void*);
        Create create = reinterpret_cast<Create>(dlsym(loaded, "JNI_CreateJavaVM"));
        if (!create)
          throw std::runtime_error("no JNI_CreateJavaVM in " + library);
        std::vector<std::string> texts = options(words);
        std::vector<jni::Option> options;
        for (const std::string& text : texts)
          options.push_back({text.c_str(), nullptr});
        jni::MachineArguments arguments = {jni::VERSION, static_cast<int32_t>(options.size()),
                                           options.data(), 0};
        if (int error = create(&machine_, &env_, &arguments))
          throw std::runtime_error("cannot start Java: error " + std::to_string(error));
      }

      /// The words by which `urbi-launch` starts Java, one a line: the program, its options, and `-cp`.
      static std::vector<std::string> command(const std::string& root)
      {
        std::string quoted;
        for (char c : root)
          quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        FILE* from = popen(("URBI_SHOW_COMMAND=1 '" + quoted + "/bin/urbi-launch'").c_str(), "r");
        std::vector<std::string> words(1);
        if (from)
        {
          for (int c = fgetc(from); c != EOF; c = fgetc(from))
            if (c == '\n')
              words.emplace_back();
            else
              words.back() += static_cast<char>(c);
          pclose(from);
        }
        words.pop_back();
        if (words.empty() || words[0].find("/bin/") == std::string::npos)
          throw std::runtime_error("no Urbi in " + root + ": set URBI_ROOT to the folder where it is");
        return words;
      }

      /// The options as the machine wants them: one word each.
      static std::vector<std::string> options(const std::vector<std::string>& words)
      {
        std::vector<std::string> all;
        for (size_t i = 1; i < words.size(); ++i)
          if (words[i] == "-cp" && i + 1 < words.size())
            all.push_back("-Djava.class.path=" + words[++i]);
          else if (words[i] == "--add-opens" && i + 1 < words.size())
            all.push_back("--add-opens=" + words[++i]);
          else
            all.push_back(words[i]);
        return all;
      }

      template <typename T>
      T function(jni::Function place) const
      {
        return reinterpret_cast<T>((*env_)[place]);
      }

      template <typename T>
      T machine_function(jni::MachineFunction place) const
      {
        return reinterpret_cast<T>((*machine_)[place]);
      }

      jni::Object found(jni::Object object) const
      {
        check();
        return object;
      }

      void check() const
      {
        if (!function<uint8_t (*)(jni::Env)>(jni::EXCEPTION_CHECK)(env_))
          return;
        function<void (*)(jni::Env)>(jni::EXCEPTION_DESCRIBE)(env_);
        throw std::runtime_error("an exception of Java");
      }

      jni::Machine machine_;
      jni::Env env_; ///< of the thread that calls
    };
  }
}

#endif
