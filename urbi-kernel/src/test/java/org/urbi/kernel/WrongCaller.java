package org.urbi.kernel;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.kernel.builtin.BuiltinTable;

/** Makes wrong calls of builtins, one after the other, with kernels confined to a directory. */
final class WrongCaller implements AutoCloseable {
  /** A builtin of a type. */
  record Builtin(BuiltinTable table, int index) {
    @Override
    public String toString() {
      return table.type() + "." + table.name(index);
    }
  }

  /** What ends the kernel is meant to do so; all else must not. */
  private static final Set<String> ENDING = Set.of("System.shutdown");

  private static final Pattern EXPECTED =
      Pattern.compile(
          ": (?:target|argument (\\d+)): unexpected .*, expected an? ([\\w.]+)", Pattern.DOTALL);

  /** One call in so many has a wrong number of arguments. */
  private static final int WRONG_ARITY = 10;

  /** One value in so many is of any type, not of the one that was asked for. */
  private static final int WRONG_TYPE = 4;

  private final Path directory;
  private final long seed;
  private final WrongValues values = new WrongValues();
  private final Map<WrongCallKernel.Result, Integer> results =
      new EnumMap<>(WrongCallKernel.Result.class);
  private final List<String> defects = new ArrayList<>();
  private WrongCallKernel kernel;
  private int kernels;

  /**
   * @param directory for the files of the calls, in a folder for each kernel
   */
  WrongCaller(Path directory, long seed) {
    this.directory = directory;
    this.seed = seed;
    kernel().teach(values);
    dismissKernel();
  }

  /** What has not been answered as it should, each with the call. */
  List<String> defects() {
    return defects;
  }

  /** How many calls had which result. */
  Map<WrongCallKernel.Result, Integer> results() {
    return results;
  }

  private WrongCallKernel kernel() {
    if (kernel == null) {
      try {
        // What an ended kernel was doing outside may not be over yet.
        kernel = new WrongCallKernel(Files.createDirectory(directory.resolve("" + ++kernels)));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    return kernel;
  }

  private void dismissKernel() {
    if (kernel != null) {
      kernel.close();
      kernel = null;
    }
  }

  @Override
  public void close() {
    dismissKernel();
  }

  /** Makes so many calls, unless one of them shows a defect. */
  void test(Builtin builtin, int calls) {
    try {
      new Turn(builtin).make(calls);
    } catch (WrongCallKernel.Defect e) {
      defects.add(builtin + ": " + e.getMessage());
    }
  }

  /** The calls of one builtin. */
  private final class Turn {
    private final Builtin builtin;
    private final SplittableRandom random;
    private final Map<Integer, String> types = new LinkedHashMap<>();
    private final KnownAnswers known = new KnownAnswers(values);
    private WrongCall last;
    private int made;

    Turn(Builtin builtin) {
      this.builtin = builtin;
      random = new SplittableRandom(seed ^ builtin.toString().hashCode());
      types.put(0, builtin.table.type());
    }

    void make(int calls) {
      while (made < calls) {
        try {
          kernel()
              .within((run, job) -> {
                while (made < calls) {
                  last = next();
                  if (known.contain(last)) {
                    made++;
                    results.merge(WrongCallKernel.Result.KNOWN, 1, Integer::sum);
                    continue;
                  }
                  WrongCallKernel.Answer answer = run.make(job, last);
                  made++;
                  results.merge(answer.result(), 1, Integer::sum);
                  learn(answer);
                }
              });
        } catch (WrongCallKernel.Spoilt e) {
          made++;
          results.merge(WrongCallKernel.Result.SPOILT, 1, Integer::sum);
          dismissKernel();
        } catch (WrongCallKernel.Ended e) {
          made++;
          results.merge(WrongCallKernel.Result.ENDED, 1, Integer::sum);
          ended();
        } catch (WrongCallKernel.Defect e) {
          made++;
          results.merge(WrongCallKernel.Result.SPOILT, 1, Integer::sum);
          dismissKernel();
          confirm(e);
        }
      }
    }

    /** In a kernel that no other call has changed; only what Java has thrown is always a defect. */
    private void confirm(WrongCallKernel.Defect defect) {
      if (defect.isCertain()) {
        throw defect;
      }
      try {
        kernel().within((run, job) -> run.make(job, last));
      } catch (WrongCallKernel.Spoilt e) {
        dismissKernel();
      } catch (WrongCallKernel.Ended e) {
        ended();
      } catch (WrongCallKernel.Defect e) {
        dismissKernel();
        throw e;
      }
    }

    private void ended() {
      dismissKernel();
      if (!ENDING.contains(builtin.toString())) {
        throw new WrongCallKernel.Defect("the kernel has ended: " + last.source());
      }
    }

    /** The next time that argument may be of the type that was expected. */
    private void learn(WrongCallKernel.Answer answer) {
      Matcher expected = answer.text() == null ? null : EXPECTED.matcher(answer.text());
      if (expected != null && expected.find()) {
        int place = expected.group(1) == null ? 0 : Integer.parseInt(expected.group(1));
        types.put(place, expected.group(2));
        if (answer.isOfDeclaration() && place <= last.arguments().size()) {
          known.refused(last, place, expected.group(2));
        }
      }
    }

    private WrongCall next() {
      int min = builtin.table.minArguments(builtin.index);
      int max = Math.min(builtin.table.maxArguments(builtin.index), min + 3);
      int count = random.nextInt(min, max + 1);
      if (random.nextInt(WRONG_ARITY) == 0) {
        count = random.nextBoolean() ? Math.max(0, min - 1) : max + 1 + random.nextInt(3);
      }
      List<String> arguments = new ArrayList<>();
      for (int place = 1; place <= count; place++) {
        arguments.add(value(place));
      }
      return new WrongCall(builtin.table, builtin.index, value(0), arguments);
    }

    private String value(int place) {
      String type = types.get(place);
      return type == null || random.nextInt(WRONG_TYPE) == 0
          ? values.any(random)
          : values.of(type, random);
    }
  }
}
