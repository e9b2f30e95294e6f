package org.urbi.kernel.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.FilterInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobThreads;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.World;
import org.urbi.kernel.time.SystemClock;

/** Programs that end well, badly, or leave others behind. */
class ChildProcessTest {
  /** What a job does that may fail in Java. */
  private interface Work {
    void run(Outside outside, Job job) throws Exception;
  }

  /** Does it in a kernel, which ends when nothing is left to do. */
  private static void inKernel(Work work) throws Exception {
    World world = new World();
    List<Throwable> failures = new ArrayList<>();
    Scheduler scheduler =
        new Scheduler(
            world,
            new SystemClock(),
            Journal.NONE,
            JobThreads.AUTO,
            (job, failure) -> failures.add(failure));
    try (Outside outside = new Outside(scheduler, Confinement.none(), Confinement.none())) {
      scheduler.startDetached(
          world.values().object,
          scheduler.rootScope(),
          "test",
          job -> {
            try {
              work.run(outside, job);
            } catch (Throwable e) {
              failures.add(e);
            }
            scheduler.stop();
          });
      scheduler.startLoop(failure -> {}).join();
    }
    for (Throwable failure : failures) {
      throw new AssertionError(failure);
    }
  }

  private static ChildProcess shell(Outside outside, Job job, String command) throws IOException {
    return ChildProcess.start(
        outside,
        job,
        List.of("/bin/sh", "-c", command),
        Path.of("").toAbsolutePath(),
        System.getenv());
  }

  private static String rest(ChildProcess child, Job job) throws IOException {
    StringBuilder text = new StringBuilder();
    for (int next = child.out().read(job); next >= 0; next = child.out().read(job)) {
      text.append((char) next);
    }
    return text.toString();
  }

  /** A program of which only the end is known, and streams that tell whether they are closed. */
  private static class Fake extends Process {
    final List<String> closed = new ArrayList<>();
    final InputStream out;
    boolean killed;

    Fake(InputStream out) {
      this.out = out;
    }

    private synchronized void close(String name) {
      closed.add(name);
    }

    synchronized List<String> closed() {
      return closed.stream().sorted().distinct().toList();
    }

    @Override
    public OutputStream getOutputStream() {
      return new FilterOutputStream(OutputStream.nullOutputStream()) {
        @Override
        public void close() {
          Fake.this.close("stdin");
        }
      };
    }

    private InputStream named(String name, InputStream in) {
      return new FilterInputStream(in) {
        @Override
        public void close() {
          Fake.this.close(name);
        }
      };
    }

    @Override
    public InputStream getInputStream() {
      return named("stdout", out);
    }

    @Override
    public InputStream getErrorStream() {
      return named("stderr", InputStream.nullInputStream());
    }

    @Override
    public int waitFor() {
      return 3;
    }

    @Override
    public int exitValue() {
      return 3;
    }

    @Override
    public CompletableFuture<Process> onExit() {
      return CompletableFuture.completedFuture(this);
    }

    @Override
    public void destroy() {
      killed = true;
    }
  }

  /** A stream whose only byte comes late. */
  private static InputStream late(CountDownLatch coming) {
    return new InputStream() {
      private boolean read;

      @Override
      public int read() {
        if (read) {
          return -1;
        }
        read = true;
        try {
          coming.await();
        } catch (InterruptedException e) {
          throw new IllegalStateException(e);
        }
        return 'x';
      }
    };
  }

  @Test
  void endIsToldWhenThePipesAreClosed() throws Exception {
    inKernel((outside, job) -> {
      CountDownLatch coming = new CountDownLatch(1);
      Fake fake = new Fake(late(coming));
      ChildProcess child = new ChildProcess(outside, fake, new Budget());
      for (int i = 0; i < 3; i++) {
        outside.await(job, () -> true);
        assertTrue(child.isRunning(), "its output is not there yet");
      }
      coming.countDown();
      child.join(job);
      assertEquals(List.of("stderr", "stdin", "stdout"), fake.closed());
      assertEquals(3, child.exitStatus());
      assertEquals("x", rest(child, job));
    });
  }

  @Test
  void pipeThatAnotherProgramHoldsOpenDelaysTheEndByTwoSeconds() throws Exception {
    inKernel((outside, job) -> {
      CountDownLatch never = new CountDownLatch(1);
      ChildProcess child = new ChildProcess(outside, new Fake(late(never)), new Budget());
      child.join(job);
      assertEquals("", rest(child, job));
      never.countDown();
    });
  }

  @Test
  void errorOfWhoWaitsForTheEndKillsTheProgram() throws Exception {
    inKernel((outside, job) -> {
      Fake fake =
          new Fake(InputStream.nullInputStream()) {
            @Override
            public int waitFor() {
              throw new OutOfMemoryError("of the test");
            }
          };
      ChildProcess child = new ChildProcess(outside, fake, new Budget());
      child.join(job);
      assertEquals(9, child.signal());
      assertTrue(fake.killed);
    });
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void whatKilledProgramHasWrittenIsRead() throws Exception {
    int aheadAndInThePipe = (1 << 24) + 30_000;
    inKernel((outside, job) -> {
      String command =
          "head -c " + aheadAndInThePipe + " /dev/zero; echo written >&2; exec sleep 600";
      ChildProcess child = shell(outside, job, command);
      assertEquals('w', child.err().read(job));
      child.kill();
      int count = 0;
      while (child.out().read(job) >= 0) {
        count++;
      }
      assertEquals(aheadAndInThePipe, count);
      child.join(job);
      assertEquals(9, child.signal());
    });
  }

  @Test
  void errorOfWhoReadsIsToldToTheJobThatReads() throws Exception {
    inKernel((outside, job) -> {
      InputStream broken =
          new InputStream() {
            @Override
            public int read() {
              throw new OutOfMemoryError("of the test");
            }
          };
      ChildProcess child = new ChildProcess(outside, new Fake(broken), new Budget());
      child.join(job);
      assertThrows(IOException.class, () -> child.out().read(job));
    });
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void openFilesAreAsManyAsBeforeRightAfterTheEnd() throws Exception {
    inKernel((outside, job) -> {
      shell(outside, job, "true").join(job);
      long before = openPipes();
      for (int i = 0; i < 30; i++) {
        ChildProcess child = shell(outside, job, "echo x; echo y >&2; exit 4");
        child.join(job);
        assertEquals(before, openPipes());
        assertEquals("x\n", rest(child, job));
        assertEquals(4, child.exitStatus());
      }
    });
  }

  private static long openPipes() throws IOException {
    try (var files = Files.list(Path.of("/proc/self/fd"))) {
      return files.filter(ChildProcessTest::isPipe).count();
    }
  }

  private static boolean isPipe(Path file) {
    try {
      return Files.readSymbolicLink(file).toString().startsWith("pipe:");
    } catch (IOException e) {
      return false;
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void realGrandchildDoesNotKeepTheEndBack() throws Exception {
    inKernel((outside, job) -> {
      ChildProcess child = shell(outside, job, "sleep 1000 & echo $!");
      child.join(job);
      ProcessHandle.of(Long.parseLong(rest(child, job).strip()))
          .ifPresent(ProcessHandle::destroyForcibly);
      assertEquals(0, child.exitStatus());
    });
  }

  /** A shell that runs another one, in a session of its own, which runs a third program. */
  private static final String LAUNCHER =
      "setsid sh -c 'sleep 1000 & echo $!; echo $$; wait' & wait";

  private static ProcessHandle readProcess(ChildProcess child, Job job) throws IOException {
    StringBuilder number = new StringBuilder();
    for (int next = child.out().read(job); next != '\n'; next = child.out().read(job)) {
      number.append((char) next);
    }
    return ProcessHandle.of(Long.parseLong(number.toString())).orElseThrow();
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void whatAKilledProgramHasBegunIsKilled() throws Exception {
    inKernel((outside, job) -> {
      ChildProcess child = shell(outside, job, LAUNCHER);
      ProcessHandle sleeper = readProcess(child, job);
      ProcessHandle shell = readProcess(child, job);
      child.kill();
      child.join(job);
      assertEquals(9, child.signal());
      sleeper.onExit().join();
      shell.onExit().join();
    });
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void whatProgramsHaveBegunIsKilledWithTheKernel() throws Exception {
    List<ProcessHandle> begun = new ArrayList<>();
    inKernel((outside, job) -> {
      ChildProcess child = shell(outside, job, LAUNCHER);
      begun.add(readProcess(child, job));
      begun.add(readProcess(child, job));
    });
    begun.forEach(each -> each.onExit().join());
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void whatAProgramThatHasEndedHadBegunLivesOn() throws Exception {
    Process shell = new ProcessBuilder("sh", "-c", "sleep 1000 >&- 2>&- & echo $!").start();
    String number = shell.inputReader().readLine();
    ProcessHandle sleeper = ProcessHandle.of(Long.parseLong(number)).orElseThrow();
    shell.waitFor();
    ProcessTree.kill(shell.toHandle());
    assertTrue(sleeper.isAlive());
    sleeper.destroyForcibly();
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void programThatClosesItsOutputLivesOn() throws Exception {
    inKernel((outside, job) -> {
      ChildProcess child = shell(outside, job, "exec >&- 2>&-; read line; exit 5");
      assertEquals("", rest(child, job));
      assertTrue(child.isRunning());
      child.in().write(job, new byte[] {'\n'});
      child.join(job);
      assertEquals(5, child.exitStatus());
    });
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void whoWritesToAProgramThatDoesNotReadIsToldOfItsEnd() throws Exception {
    inKernel((outside, job) -> {
      ChildProcess child = shell(outside, job, "exec sleep 1000");
      child.in().write(job, new byte[1 << 21]);
      outside.start(child::kill);
      assertThrows(IOException.class, () -> child.in().flush(job));
      child.join(job);
      assertEquals(9, child.signal());
    });
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void whatNobodyHasReadYetIsThereAfterTheEnd() throws Exception {
    inKernel((outside, job) -> {
      int more = (1 << 24) + 20_000;
      ChildProcess child = shell(outside, job, "head -c " + more + " /dev/zero");
      child.join(job);
      int read = 0;
      while (child.out().read(job) >= 0) {
        read++;
      }
      assertEquals(more, read);
    });
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void twoHundredAtOnceAllEnd() throws Exception {
    inKernel((outside, job) -> {
      List<ChildProcess> children = new ArrayList<>();
      for (int i = 0; i < 200; i++) {
        children.add(
            ChildProcess.start(
                outside, job, List.of("/bin/cat"), Path.of("").toAbsolutePath(), Map.of()));
      }
      for (ChildProcess child : children) {
        child.in().write(job, new byte[] {'a', 'b'});
        child.in().close();
      }
      for (ChildProcess child : children) {
        child.join(job);
        assertEquals("ab", rest(child, job));
        assertFalse(child.isRunning());
      }
    });
  }
}
