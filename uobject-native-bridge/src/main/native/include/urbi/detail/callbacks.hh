/// Member functions as the host calls them: with values for arguments, and a value for a result.
#ifndef URBI_DETAIL_CALLBACKS_HH
#define URBI_DETAIL_CALLBACKS_HH

#include <functional>
#include <memory>
#include <utility>

#include <urbi/detail/casters.hh>
#include <urbi/detail/wire.hh>
#include <urbi/uvar.hh>

namespace urbi
{
  namespace detail
  {
    /// What the host calls.
    class Callback
    {
    public:
      virtual ~Callback();
      virtual void call(Reader& in, Writer& out) = 0;

      /// How many arguments it has.
      virtual int64_t arity() const = 0;
    };

    // ---------------------------------------------------------------- arguments

    /// An argument of a call, for a parameter of type P: it lives until the call ends.
    template <typename P, typename = void>
    class Argument
    {
    public:
      explicit Argument(Reader& in)
        : source_(read(in))
        , value_(uvalue_cast<plain<P>>(source_))
      {}

      P get()
      {
        return static_cast<P>(value_);
      }

    private:
      static UValue read(Reader& in)
      {
        UValue value;
        in.value(value);
        return value;
      }

      UValue source_;
      plain<P> value_;
    };

    template <typename P>
    class Argument<P, std::enable_if_t<std::is_arithmetic<plain<P>>::value>>
    {
    public:
      explicit Argument(Reader& in)
      {
        ufloat number;
        if (in.number(number))
          value_ = to_number<plain<P>>(number);
        else
        {
          UValue value;
          in.value(value);
          value_ = static_cast<plain<P>>(value);
        }
      }

      P get()
      {
        return static_cast<P>(value_);
      }

    private:
      plain<P> value_;
    };

    template <typename P>
    class Argument<P, std::enable_if_t<std::is_same<plain<P>, UValue>::value>>
    {
    public:
      explicit Argument(Reader& in)
      {
        in.value(value_);
      }

      P get()
      {
        return static_cast<P>(value_);
      }

    private:
      UValue value_;
    };

    /// A variable, by its name.
    template <typename P>
    class Argument<P, std::enable_if_t<std::is_same<plain<P>, UVar>::value>>
    {
    public:
      explicit Argument(Reader& in)
      {
        UValue value;
        in.value(value);
        if (value.type != DATA_STRING && value.type != DATA_SLOTNAME)
          throw std::runtime_error("invalid cast to UVar from non-string value.");
        variable_.init(*value.stringValue);
        variable_.set_temp(true);
      }

      P get()
      {
        return static_cast<P>(variable_);
      }

    private:
      UVar variable_;
    };

    /// Arguments, read in their order.
    template <typename... Parameters>
    class Arguments
    {
    public:
      explicit Arguments(Reader&)
      {}

      template <typename Function, typename... Taken>
      decltype(auto) pass(const Function& function, Taken&&... taken)
      {
        return function(std::forward<Taken>(taken)...);
      }
    };

    template <typename First, typename... Others>
    class Arguments<First, Others...>
    {
    public:
      explicit Arguments(Reader& in)
        : first_(in)
        , others_(in)
      {}

      template <typename Function, typename... Taken>
      decltype(auto) pass(const Function& function, Taken&&... taken)
      {
        return others_.pass(function, std::forward<Taken>(taken)..., first_.get());
      }

    private:
      Argument<First> first_;
      Arguments<Others...> others_;
    };

    // ---------------------------------------------------------------- results

    template <typename T>
    void write_result(Writer& out, const T& result)
    {
      if constexpr (std::is_arithmetic<T>::value)
        out.number(static_cast<ufloat>(result));
      else if constexpr (std::is_same<T, UValue>::value)
        out.value(result);
      else if constexpr (std::is_same<T, std::string>::value)
        out.string(result);
      else if constexpr (std::is_same<T, UBinary>::value || std::is_same<T, UImage>::value
                         || std::is_same<T, USound>::value)
        out.value(UValue(result, false));
      else
      {
        UValue made;
        made = result;
        out.value(made);
      }
    }

    // ---------------------------------------------------------------- functions

    /// A member function and its object. (With UBSan, g++ 12 takes the wrong `this` in a lambda here.)
    template <typename Object, typename Function>
    struct Member
    {
      template <typename... Arguments>
      decltype(auto) operator()(Arguments&&... arguments) const
      {
        return (object->*function)(std::forward<Arguments>(arguments)...);
      }

      Object* object;
      Function function;
    };

    /// A bound function.
    template <typename Function, typename Result, typename... Parameters>
    class FunctionCallback final : public Callback
    {
    public:
      explicit FunctionCallback(const Function& function)
        : function_(function)
      {}

      int64_t arity() const override
      {
        return sizeof...(Parameters);
      }

      void call(Reader& in, Writer& out) override
      {
        Arguments<Parameters...> arguments(in);
        if constexpr (std::is_void<Result>::value)
        {
          arguments.pass(function_);
          out.nothing();
        }
        else
          write_result(out, arguments.pass(function_));
      }

    private:
      Function function_;
    };

    /// Has a variable know its value, which comes with the call, until that ends.
    class Telling
    {
    public:
      Telling(UVar& variable, Reader& in)
        : told_{&variable, thread_state().told}
      {
        if (!in.ended())
        {
          variable.tell(in);
          thread_state().told = &told_;
        }
      }

      ~Telling()
      {
        thread_state().told = told_.outer;
      }

      Telling(const Telling&) = delete;
      Telling& operator=(const Telling&) = delete;

    private:
      Told told_;
    };

    /// A function that is told of changes or accesses: it takes nothing, the UVar, or the value.
    /// The host gives the value to those that do not take it as well, if it was not copied.
    template <typename Function, typename... Parameters>
    class NotificationCallback final : public Callback
    {
      static_assert(sizeof...(Parameters) <= 1, "a notification has at most one argument");
      static constexpr bool takes_variable = (std::is_base_of<UVar, plain<Parameters>>::value || ...);

    public:
      /// \param own  whether the variable lives as long as this
      NotificationCallback(const Function& function, UVar* variable, bool own)
        : function_(function)
        , variable_(variable)
        , owned_(own ? variable : nullptr)
      {}

      int64_t arity() const override
      {
        return takes_variable ? 0 : sizeof...(Parameters);
      }

      void call(Reader& in, Writer& out) override
      {
        if constexpr (takes_variable || sizeof...(Parameters) == 0)
        {
          Telling telling(*variable_, in);
          function_(static_cast<plain<Parameters>&>(*variable_)...);
        }
        else
        {
          Arguments<Parameters...> arguments(in);
          arguments.pass(function_);
        }
        out.nothing();
      }

    private:
      Function function_;
      UVar* variable_;
      std::unique_ptr<UVar> owned_;
    };

    // ---------------------------------------------------------------- from what is given for a function

    /// The object of a class of which a pointer to a member was given.
    template <typename Class, typename Base>
    Class* self(Base* base)
    {
      if constexpr (std::is_base_of<Class, Base>::value)
        return base;
      else
      {
        Class* object = dynamic_cast<Class*>(base);
        if (!object)
          throw std::runtime_error("the function of another class");
        return object;
      }
    }

    /// What is called, with its signature.
    template <typename Function, typename Result, typename... Parameters>
    struct Signed
    {
      static constexpr size_t arity = sizeof...(Parameters);

      std::unique_ptr<Callback> function() const
      {
        return std::unique_ptr<Callback>(
          new FunctionCallback<Function, Result, Parameters...>(called));
      }

      std::unique_ptr<Callback> notification(UVar* variable, bool own) const
      {
        return std::unique_ptr<Callback>(
          new NotificationCallback<Function, Parameters...>(called, variable, own));
      }

      Function called;
    };

    template <typename Base, typename R, typename C, typename... P>
    Signed<Member<C, R (C::*)(P...)>, R, P...> bound(Base* base, R (C::*f)(P...))
    {
      return {{self<C>(base), f}};
    }

    template <typename Base, typename R, typename C, typename... P>
    Signed<Member<C, R (C::*)(P...) const>, R, P...> bound(Base* base, R (C::*f)(P...) const)
    {
      return {{self<C>(base), f}};
    }

    template <typename R, typename... P>
    Signed<R (*)(P...), R, P...> bound(R (*f)(P...))
    {
      return {f};
    }

    template <typename R, typename... P>
    Signed<std::function<R(P...)>, R, P...> bound(const std::function<R(P...)>& f)
    {
      return {f};
    }
  }
}

#endif
