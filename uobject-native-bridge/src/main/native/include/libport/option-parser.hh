/// Options of programs.
#ifndef LIBPORT_OPTION_PARSER_HH
#define LIBPORT_OPTION_PARSER_HH

#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <libport/cli.hh>
#include <libport/file-system.hh>
#include <libport/foreach.hh>
#include <libport/format.hh>
#include <libport/input-arguments.hh>

namespace libport
{
  class OptionParser;

  /// An option. Takes what belongs to it out of the arguments.
  class Option
  {
  public:
    explicit Option(const std::string& documentation)
      : documentation_(documentation)
    {}

    virtual ~Option() = default;

    /// Takes the first words, if they are of this option. \return whether they were
    virtual bool test(cli_args_type& words) = 0;
    virtual void usage(std::ostream& out) const = 0;
    virtual void doc(std::ostream& out) const = 0;

  protected:
    std::string documentation_;
  };

  /// One with a name: --long, -s.
  class OptionNamed : public Option
  {
  public:
    OptionNamed(const std::string& documentation, const std::string& name_long, char name_short = 0)
      : Option(documentation)
      , long_(name_long)
      , short_(name_short)
    {}

    /// Called each time when the option was there.
    void set_callback(const std::function<void()>* callback)
    {
      callback_ = callback ? *callback : std::function<void()>();
    }

  protected:
    bool is_name(const std::string& word) const
    {
      return word == "--" + long_ || (short_ && word == std::string("-") + short_);
    }

    void show(std::ostream& out, const std::string& argument) const
    {
      std::string names = short_ ? std::string("  -") + short_ + ", --" : std::string("      --");
      names += long_ + argument;
      out << names << std::string(names.size() < 28 ? 28 - names.size() : 1, ' ') << documentation_
          << "\n";
    }

    void called() const
    {
      if (callback_)
        callback_();
    }

    std::string long_;
    char short_;
    std::function<void()> callback_;
  };

  /// One that is there or not.
  class OptionFlag : public OptionNamed
  {
  public:
    OptionFlag(const std::string& documentation, const std::string& name_long, char name_short = 0)
      : OptionNamed(documentation, name_long, name_short)
      , value_(false)
    {}

    bool test(cli_args_type& words) override
    {
      if (!is_name(words[0]))
        return false;
      words.erase(words.begin());
      value_ = true;
      called();
      return true;
    }

    bool get() const
    {
      return value_;
    }

    void usage(std::ostream& out) const override
    {
      out << "--" << long_;
    }

    void doc(std::ostream& out) const override
    {
      show(out, "");
    }

  private:
    bool value_;
  };

  /// What options with an argument have in common.
  class OptionArgument : public OptionNamed
  {
  public:
    OptionArgument(const std::string& documentation, const std::string& name_long, char name_short,
                   const std::string& formal, bool = false)
      : OptionNamed(documentation, name_long, name_short)
      , formal_(formal)
    {}

    bool test(cli_args_type& words) override
    {
      std::string with = "--" + long_ + "=";
      if (words[0].compare(0, with.size(), with) == 0)
      {
        take(words[0].substr(with.size()));
        words.erase(words.begin());
      }
      else if (is_name(words[0]))
      {
        if (words.size() < 2)
          required_argument(words[0]);
        take(words[1]);
        words.erase(words.begin(), words.begin() + 2);
      }
      else
        return false;
      called();
      return true;
    }

    void usage(std::ostream& out) const override
    {
      out << "--" << long_ << "=" << formal_;
    }

    void doc(std::ostream& out) const override
    {
      show(out, "=" + formal_);
    }

  protected:
    virtual void take(const std::string& argument) = 0;

    std::string formal_;
  };

  /// One with an argument, of which the last one counts.
  class OptionValue : public OptionArgument
  {
  public:
    OptionValue(const std::string& documentation, const std::string& name_long, char name_short = 0,
                const std::string& formal = "VALUE", bool = false)
      : OptionArgument(documentation, name_long, name_short, formal)
      , filled_(false)
    {}

    /// Whether it was there.
    bool filled() const
    {
      return filled_;
    }

    /// Its argument. \throw std::runtime_error without
    std::string value() const
    {
      if (!filled_)
        throw std::runtime_error("option --" + long_ + " was not given");
      return value_;
    }

    std::string value(const std::string& otherwise) const
    {
      return filled_ ? value_ : otherwise;
    }

    template <typename T>
    T get() const
    {
      return convert_argument<T>("--" + long_, value());
    }

    template <typename T>
    T get(const T& otherwise) const
    {
      return filled_ ? get<T>() : otherwise;
    }

  protected:
    void take(const std::string& argument) override
    {
      filled_ = true;
      value_ = argument;
    }

  private:
    bool filled_;
    std::string value_;
  };

  /// One with an argument that may be there any number of times.
  class OptionValues : public OptionArgument
  {
  public:
    typedef std::vector<std::string> values_type;

    OptionValues(const std::string& documentation, const std::string& name_long,
                 char name_short = 0, const std::string& formal = "VALUE", bool = false)
      : OptionArgument(documentation, name_long, name_short, formal)
    {}

    const values_type& get() const
    {
      return values_;
    }

  protected:
    void take(const std::string& argument) override
    {
      values_.push_back(argument);
    }

  private:
    values_type values_;
  };

  /// Takes the options out of the arguments of a program.
  class OptionParser
  {
  public:
    OptionParser& operator<<(Option& option)
    {
      parts_.push_back(Part{"", &option});
      return *this;
    }

    /// A line of its documentation.
    OptionParser& operator<<(const std::string& text)
    {
      parts_.push_back(Part{text, nullptr});
      return *this;
    }

    /// \return the arguments that are no options; all of those after --
    cli_args_type operator()(const cli_args_type& arguments)
    {
      cli_args_type left = arguments;
      cli_args_type others;
      while (!left.empty())
        if (left[0] == "--")
        {
          others.insert(others.end(), left.begin() + 1, left.end());
          break;
        }
        else if (!taken(left))
        {
          others.push_back(left[0]);
          left.erase(left.begin());
        }
      return others;
    }

    void options_doc(std::ostream& out) const
    {
      for (const Part& each : parts_)
        if (each.option)
          each.option->doc(out);
        else
          out << each.text << "\n";
    }

    void usage(std::ostream& out) const
    {
      for (const Part& each : parts_)
        if (each.option)
        {
          out << " [";
          each.option->usage(out);
          out << "]";
        }
    }

  private:
    struct Part
    {
      std::string text;
      Option* option;
    };

    bool taken(cli_args_type& left)
    {
      for (const Part& each : parts_)
        if (each.option && each.option->test(left))
          return true;
      return false;
    }

    std::vector<Part> parts_;
  };

  inline std::ostream& operator<<(std::ostream& out, const OptionParser& parser)
  {
    parser.options_doc(out);
    return out;
  }

  namespace opts
  {
    /// One whose arguments are input_arguments.
    class OptionInput : public OptionArgument
    {
    public:
      OptionInput(const std::string& documentation, const std::string& name_long, char name_short,
                  const std::string& formal, std::function<void(const std::string&)> add)
        : OptionArgument(documentation, name_long, name_short, formal)
        , add_(add)
      {}

    protected:
      void take(const std::string& argument) override
      {
        add_(argument);
      }

    private:
      std::function<void(const std::string&)> add_;
    };

    // The options that most programs have.
    static OptionFlag help("show this and exit", "help", 'h');
    static OptionFlag version("show the version and exit", "version", 'V');
    static OptionFlag verbose("say what is done", "verbose", 'v');
    static OptionFlag quiet("say nothing but errors", "quiet", 'q');
    static OptionValue host("the address of the server", "host", 'H', "ADDR");
    static OptionValue port("the port of the server", "port", 'P', "PORT");
    static OptionValue port_file("read the port from a file", "port-file", 0, "FILE");
    static OptionInput exp("send a text", "expression", 'e', "EXP",
                           [](const std::string& text) { input_arguments.add_exp(text); });
    static OptionInput file("send the contents of a file", "file", 'f', "FILE",
                            [](const std::string& name) { input_arguments.add_file(name); });
    static OptionInput module("load a module", "module", 'm', "MODULE", [](const std::string& name) {
      input_arguments.add_exp("loadModule(\"" + name + "\");");
    });
    static OptionValues files("load a file", "file", 'f', "FILE");
  }
}

#endif
