/// Texts and files that a program is to send, in the order of its arguments.
#ifndef LIBPORT_INPUT_ARGUMENTS_HH
#define LIBPORT_INPUT_ARGUMENTS_HH

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace libport
{
  namespace opts
  {
    class DataVisitor;

    /// A text, or the name of a file.
    class Data
    {
    public:
      virtual ~Data() = default;
      virtual void accept(DataVisitor& visitor) const = 0;
      virtual std::ostream& dump(std::ostream& out) const = 0;
    };

    class TextData;
    class FileData;
    class DataList;

    /// What becomes of them.
    class DataVisitor
    {
    public:
      virtual ~DataVisitor() = default;

      virtual void operator()(const Data& data)
      {
        data.accept(*this);
      }

      virtual void operator()(const TextData& data) = 0;
      virtual void operator()(const FileData& data) = 0;
      void operator()(const DataList& all);
    };

    class TextData : public Data
    {
    public:
      explicit TextData(const std::string& text)
        : command_(text)
      {}

      void accept(DataVisitor& visitor) const override
      {
        visitor(*this);
      }

      std::ostream& dump(std::ostream& out) const override
      {
        return out << "text `" << command_ << "'";
      }

      std::string command_;
    };

    class FileData : public Data
    {
    public:
      explicit FileData(const std::string& file)
        : filename_(file)
      {}

      void accept(DataVisitor& visitor) const override
      {
        visitor(*this);
      }

      std::ostream& dump(std::ostream& out) const override
      {
        return out << "file `" << filename_ << "'";
      }

      std::string filename_;
    };

    inline std::ostream& operator<<(std::ostream& out, const Data& data)
    {
      return data.dump(out);
    }

    /// All there are.
    class DataList
    {
    public:
      DataList() = default;
      DataList(const DataList&) = delete;
      DataList& operator=(const DataList&) = delete;

      ~DataList()
      {
        clear();
      }

      void add_exp(const std::string& text)
      {
        all_.push_back(new TextData(text));
      }

      void add_file(const std::string& file)
      {
        all_.push_back(new FileData(file));
      }

      bool empty() const
      {
        return all_.empty();
      }

      size_t size() const
      {
        return all_.size();
      }

      void clear()
      {
        for (Data* each : all_)
          delete each;
        all_.clear();
      }

      std::vector<Data*>::const_iterator begin() const
      {
        return all_.begin();
      }

      std::vector<Data*>::const_iterator end() const
      {
        return all_.end();
      }

    private:
      std::vector<Data*> all_;
    };

    inline void DataVisitor::operator()(const DataList& all)
    {
      for (const Data* each : all)
        (*this)(*each);
    }

    /// Those of this program: filled by the options \c exp, \c file and \c module.
    static DataList input_arguments;
  }
}

#endif
