package org.urbi.tests;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.IntFunction;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.tests.KernelSession.BackEnd;
import org.urbi.tests.KernelSession.Console;

/**
 * Feeds consoles with random bytes, and with programs cut or damaged at random. After each of them,
 * the next console still answers. Seeds are fixed and counts bounded.
 */
class ConsoleFuzzTest {
  private static final int PROGRAMS = Integer.getInteger("urbi.fuzz.programs", 120);
  private static final int PROGRAMS_PER_KERNEL = 20;

  /** What would end the session, and is no news, or would never give way to the next console. */
  static final Pattern UNFIT = Pattern.compile("shutdown|quit|(?:while|loop|for) ?\\|");

  @ParameterizedTest
  @EnumSource
  void tokenSoupLeavesTheKernelAlive(BackEnd backEnd) throws Exception {
    feed(backEnd, i -> new ProgramGenerator(1_000 + i).soup());
  }

  @ParameterizedTest
  @EnumSource
  void truncatedProgramsLeaveTheKernelAlive(BackEnd backEnd) throws Exception {
    List<String> programs = programs();
    feed(backEnd, i -> new ProgramGenerator(2_000 + i).cut(programs.get(i % programs.size())));
  }

  @ParameterizedTest
  @EnumSource
  void programsWithGapsLeaveTheKernelAlive(BackEnd backEnd) throws Exception {
    List<String> programs = programs();
    feed(backEnd, i -> new ProgramGenerator(3_000 + i).gap(programs.get(i % programs.size())));
  }

  @ParameterizedTest
  @EnumSource
  void damagedProgramsLeaveTheKernelAlive(BackEnd backEnd) throws Exception {
    List<String> programs = programs();
    feed(backEnd, i -> new ProgramGenerator(4_000 + i).damage(programs.get(i % programs.size())));
  }

  @Test
  void thereAreProgramsToDamage() {
    if (programs().size() < 100) {
      throw new AssertionError("only " + programs().size() + " programs");
    }
  }

  /** Real time: in virtual time what a program leaves running would spin as fast as it can. */
  private static void feed(BackEnd backEnd, IntFunction<String> programs) throws Exception {
    for (int i = 0; i < PROGRAMS; ) {
      try (KernelSession session = KernelSession.inRealTime(backEnd)) {
        do {
          String program = programs.apply(i++);
          if (!UNFIT.matcher(program).find()) {
            Console victim = session.connect();
            victim.send(program);
            victim.end();
            answers(session.connect(), program);
          }
        } while (i < PROGRAMS && i % PROGRAMS_PER_KERNEL != 0);
      }
    }
  }

  private static void answers(Console console, String program) {
    try {
      console.send("1+1;\n");
      console.receives("] 2\n").get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
      console.end();
    } catch (Exception e) {
      throw new AssertionError(
          "no answer after this program:\n" + program + "\nbut:\n" + console.output(), e);
    }
  }

  private static List<String> programs() {
    List<String> programs = new ArrayList<>();
    for (List<Path> files : Transcripts.byFolder().values()) {
      for (Path file : files) {
        String input = Transcript.read(file).input();
        if (!UNFIT.matcher(input).find()) {
          programs.add(input);
        }
      }
    }
    return programs;
  }
}
