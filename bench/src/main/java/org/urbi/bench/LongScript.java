package org.urbi.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** A script of two thousand lines that defines functions and calls none of them. */
final class LongScript {
  private static final int FUNCTIONS = 250;

  private LongScript() {}

  /** Writes it in a language, with Hello, World at its end, into a folder. */
  static Path write(Path folder, Language language) throws IOException {
    String function =
        switch (language) {
          case PYTHON ->
              """
              def f%1$d(a, b):
                  x = a * %1$d + b
                  if x > %1$d:
                      x = x - b * 2
                  else: print("value %%s" %% x)
                  for k in range(b):
                      x += len(names[%1$d][k])
                  return x == %1$d
              """;
          case LUA ->
              """
              function f%1$d(a, b)
                local x = a * %1$d + b
                if x > %1$d then x = x - b * 2
                else print("value " .. x) end
                for k = 1, b do
                  x = x + #names[%1$d][k]
                end
                return x == %1$d end
              """;
          default ->
              """
              function f%1$d(a, b) {
                var x = a * %1$d + b;
                if (x > %1$d) { x = x - b * 2 }
                else { echo("value %%s" %% x) };
                for (var k = 0; k < b; k++)
                  x += names[%1$d][k].size;
                x == %1$d
              };
              """;
        };
    String end =
        switch (language) {
          case PYTHON, LUA -> "print('Hello, World!')\n";
          default -> "echo(\"Hello, World!\"); shutdown;\n";
        };
    StringBuilder script = new StringBuilder();
    for (int i = 0; i < FUNCTIONS; i++) {
      script.append(function.formatted(i));
    }
    Path file = folder.resolve("long." + language.name().toLowerCase(Locale.ROOT));
    return Files.writeString(file, script.append(end));
  }
}
