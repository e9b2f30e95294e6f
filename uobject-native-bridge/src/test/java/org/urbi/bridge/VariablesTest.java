package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Variables of C++ in their less usual modes, and binaries that many have at a time. */
class VariablesTest {
  private static final String CODE =
      """
      #include <atomic>
      class Source : public urbi::UObject
      {
      public:
        Source(const std::string& s) : urbi::UObject(s)
        {
          UBindFunctions(Source, bypass, set, plain);
          UBindVars(Source, v, w);
          memset(block, 'a', sizeof block);
          v = 0;
          only = this;
        }
        void bypass(bool on) { v.setBypass(on); }
        void plain(int n) { w = n; }
        void set(int c)
        {
          urbi::UBinary b;
          b.type = urbi::BINARY_UNKNOWN;
          b.common.size = sizeof block;
          b.common.data = block;
          block[0] = static_cast<char>(c);
          v = b;
          b.common.data = 0;
        }
        char block[100];
        urbi::UVar v, w;
        static Source* only;
      };
      Source* Source::only;
      UStart(Source);
      class Reader : public urbi::UObject
      {
      public:
        Reader(const std::string& s) : urbi::UObject(s), depth(0)
        {
          UBindFunctions(Reader, watch, init, told);
          UBindVars(Reader, seen, again);
        }
        ~Reader() override { ++ended; }
        int init() { return 0; }
        void watch(const std::string& name, bool change)
        {
          if (change)
            UNotifyChange(name, &Reader::changed);
          else
            UNotifyChange(name, &Reader::look);
        }
        // Reads what it is told of, and has it changed while it reads.
        int changed(urbi::UVar& u)
        {
          const urbi::UBinary& b = u;
          char first = static_cast<char*>(b.common.data)[0];
          if (!depth++)
          {
            Source::only->set('z');
            again = std::string(1, static_cast<char*>(b.common.data)[0]);
          }
          --depth;
          seen = std::string(1, first);
          return 0;
        }
        int look(urbi::UVar& u)
        {
          seen = (int)u;
          ++calls;
          return 0;
        }
        int told() { return calls; }
        int depth;
        static std::atomic<int> ended, calls;
        urbi::UVar seen, again;
      };
      std::atomic<int> Reader::ended, Reader::calls;
      UStart(Reader);
      class Blocks : public urbi::UObject
      {
      public:
        Blocks(const std::string& s) : urbi::UObject(s)
        {
          UBindThreadedFunction(Blocks, twice, urbi::LOCK_NONE);
          UBindThreadedFunction(Blocks, keep, urbi::LOCK_NONE);
          UBindVar(Blocks, last);
        }
        urbi::UBinary twice(urbi::UBinary b)
        {
          urbi::UBinary made;
          made.type = urbi::BINARY_UNKNOWN;
          made.common.size = 2 * b.common.size;
          made.common.data = malloc(made.common.size);
          for (size_t i = 0; i < made.common.size; ++i)
            static_cast<char*>(made.common.data)[i] = static_cast<char*>(b.common.data)[i / 2];
          return made;
        }
        size_t keep(const urbi::UBinary& b)
        {
          last = b;
          urbi::UBinary own = last;
          urbi::UBinary other(own);
          other = b;
          return other.common.size;
        }
        urbi::UVar last;
      };
      UStart(Blocks);
      """;

  private static String run(String program) {
    return Dialogue.run(program, CxxCompiler.libraryOf("variables", CODE));
  }

  /** Who reads a variable in bypass mode gets the next value, or nil after half a second. */
  @Test
  void readerInBypassModeIsReleased() {
    String output =
        run(
            """
            Source.bypass(true)|;
            var before = time|;
            { sleep(100ms); Source.set(98) }, var got = Source.v|;
            got.isA(Binary); (10 * (time - before)).round;
            before = time|;
            Source.v == nil; (10 * (time - before)).round;
            Source.bypass(false)|; Source.w = 4|; Source.w;
            """);
    assertTrue(
        output.contains("] true\n[00000100] 1\n[00000600] true\n[00000600] 5\n[00000600] 4"),
        output);
  }

  /** A reader may have the variable changed that it reads. */
  @Test
  void aChangeInsideTheReader() {
    String output =
        run(
            """
            Source.bypass(true)|;
            Reader.watch("Source.v", true)|;
            Source.set(98)|;
            Reader.seen; Reader.again;
            Source.set(99)|;
            Reader.seen;
            """);
    assertFalse(output.contains("!!!"), output);
    assertTrue(output.contains("] \"b\"\n[00000000] \"z\"\n[00000000] \"c\""), output);
  }

  /** An object that has been destroyed is not told of anything any more. */
  @Test
  void destroyedObjectsAreNotNotified() {
    String output =
        run(
            """
            var r = Reader.new()|; var t = Reader.new()|;
            r.watch("Source.w", false)|; t.watch("Source.w", false)|;
            Source.w = 1|; Reader.told;
            r.destroy|; r = nil|;
            Source.w = 2|; Reader.told; t.seen;
            t.destroy|;
            Source.plain(3)|; Reader.told; Source.w;
            """);
    assertFalse(output.contains("!!!"), output);
    assertTrue(
        output.contains("] 2\n[00000000] 3\n[00000000] 2\n[00000000] 3\n[00000000] 3\n"), output);
  }

  /** Threaded functions that take, keep and give binaries at the same time. */
  @Test
  void binariesOnThreads() {
    String output =
        run(
            """
            var block = Binary.new("", "x" * 10000)|;
            var good = 0|;
            for& (var i: 20)
              for (3)
              {
                if (Blocks.twice(block).data.size == 20000) good++;
                if (Blocks.keep(block) == 10000) good++;
              };
            good; Blocks.last.data.size;
            """);
    assertFalse(output.contains("!!!"), output);
    assertTrue(output.contains("] 120\n") && output.contains("] 10000\n"), output);
  }
}
