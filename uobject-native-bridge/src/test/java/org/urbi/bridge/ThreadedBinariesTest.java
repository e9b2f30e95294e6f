package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Binaries that threads of a component are given, return, write and hear of. */
class ThreadedBinariesTest {
  @Test
  void eachIsFreedOnce() {
    Path file =
        CxxCompiler.libraryOf(
            "threadedbinaries",
            """
            class Lens : public urbi::UObject
            {
            public:
              Lens(const std::string& s) : urbi::UObject(s)
              {
                UBindThreadedFunction(Lens, same, urbi::LOCK_NONE);
                UBindThreadedFunction(Lens, image, urbi::LOCK_NONE);
                UBindThreadedFunction(Lens, list, urbi::LOCK_INSTANCE);
                UBindThreadedFunction(Lens, write, urbi::LOCK_NONE);
                UBindVar(Lens, val);
                UBindVar(Lens, heard);
                UNotifyThreadedChange(val, &Lens::changed, urbi::LOCK_FUNCTION);
              }
              urbi::UBinary same(urbi::UBinary b) { return b; }
              urbi::UImage image(urbi::UImage i) { i.width = 1; return i; }
              urbi::UList list(urbi::UList l) { l.push_back(l[0]); return l; }
              int write(urbi::UBinary b) { val = b; urbi::UBinary mine = val; return mine.common.size; }
              void changed(urbi::UVar& v) { urbi::UBinary b = v; heard = (int)b.common.size; }
              urbi::UVar val, heard;
            };
            UStart(Lens);
            """);
    String output =
        Dialogue.run(
            """
            var done = 0|;
            for& (var i : 60) {
              var b = Binary.new("lens " + i, "ab" * (500 + i))|
              assert (Lens.same(b) == b)|
              assert (Lens.list([b])[1] == b)|
              assert (Lens.image(Binary.new("rgb 2 1", "abcdef")).keywords == "rgb 1 1")|
              Lens.write(b)|
              done += 1
            };
            done;
            while (Lens.heard.isVoid) sleep(10ms); Lens.heard > 900;
            """,
            file);
    assertTrue(output.contains("] 60\n"), output);
    assertTrue(output.contains("] true\n"), output);
  }
}
