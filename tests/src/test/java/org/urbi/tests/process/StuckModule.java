package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.urbi.server.make.UmakeJava;

/** A module in Java whose functions never return. */
final class StuckModule {
  private StuckModule() {}

  /** Compiles it in a folder, and returns its jar. */
  static Path in(Path folder) throws IOException {
    Path sources = Files.createDirectory(folder.resolve("stuck.uob"));
    Files.writeString(
        sources.resolve("Stuck.java"),
        """
        import urbi.UObject;

        public class Stuck extends UObject {
          static { UStart(Stuck.class); }

          public Stuck(String name) {
            super(name);
            UBindFunction(this, "spin");
            UBindFunction(this, "park");
          }

          public int spin() {
            while (true) {
              Thread.onSpinWait();
            }
          }

          public int park() {
            while (true) {
              java.util.concurrent.locks.LockSupport.park();
            }
          }
        }
        """);
    Path jar = folder.resolve("stuck.jar");
    String[] words = {"-q", sources.toString(), "-o", jar.toString()};
    assertEquals(0, UmakeJava.run(words, System.out, System.err));
    return jar;
  }
}
