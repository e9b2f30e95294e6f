package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.lang.classfile.ClassFile;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import urbi.spi.Failure;

/** What {@link CatchLaw} takes for silence, and what not. */
class CatchLawTest {
  /** Each of them forgets what it has caught. */
  @SuppressWarnings({"unused", "EmptyCatch"})
  private static final class Silent {
    private final StringBuilder shown = new StringBuilder();

    void forgets(Runnable task) {
      try {
        task.run();
      } catch (Throwable ignored) {
        // Nobody learns of it.
      }
    }

    String message(Runnable task) {
      try {
        task.run();
        return "";
      } catch (RuntimeException e) {
        return "broken: " + e.getMessage();
      }
    }

    String shown(Runnable task) {
      try {
        task.run();
        return "";
      } catch (IllegalStateException | Error e) {
        return "broken: " + e;
      }
    }

    IllegalStateException text(Runnable task) {
      try {
        task.run();
        return null;
      } catch (Exception e) {
        return new IllegalStateException(Failure.text(e));
      }
    }

    void compares(Runnable task) {
      try {
        task.run();
      } catch (RuntimeException e) {
        shown.append(e instanceof IllegalStateException);
      }
    }

    Runnable later(Runnable task) {
      return () -> {
        try {
          task.run();
        } catch (Error e) {
          shown.append(e);
        }
      };
    }
  }

  /** Each of them hands it on, or catches what is thought of. */
  @SuppressWarnings({"unused", "EmptyCatch"})
  private static final class Heard {
    private Throwable failure;

    void again(Runnable task) {
      try {
        task.run();
      } catch (RuntimeException | Error e) {
        failure = null;
        throw e;
      }
    }

    void cause(Runnable task) {
      try {
        task.run();
      } catch (RuntimeException e) {
        throw new IllegalStateException("broken: " + e.getMessage(), e);
      }
    }

    void kept(Runnable task) {
      try {
        task.run();
      } catch (Throwable e) {
        failure = e;
      }
    }

    void waiting(Runnable task, CompletableFuture<Void> end) {
      try {
        task.run();
      } catch (Throwable e) {
        end.completeExceptionally(e);
      }
    }

    void logged(Runnable task, Consumer<Throwable> log) {
      try {
        task.run();
      } catch (Exception e) {
        log.accept(e);
      }
    }

    Runnable later(Runnable task, Consumer<Throwable> log) {
      try {
        task.run();
        return () -> {};
      } catch (Exception e) {
        return () -> log.accept(e);
      }
    }

    void narrow(Runnable task) {
      try {
        task.run();
      } catch (IllegalStateException e) {
        // That it may do so is known.
      }
    }

    void resource(Closeable resource) throws IOException {
      try (resource) {
        failure = null;
      } finally {
        failure = null;
      }
    }
  }

  private static Set<String> silentIn(Class<?> type) throws IOException {
    try (InputStream in =
        type.getResourceAsStream("/" + type.getName().replace('.', '/') + ".class")) {
      var names = new TreeSet<String>();
      CatchLaw.silentIn(ClassFile.of().parse(in.readAllBytes()))
          .forEach(name -> names.add(name.substring(name.lastIndexOf('.') + 1)));
      return names;
    }
  }

  @Test
  void whoeverForgetsIsFound() throws IOException {
    assertEquals(
        new TreeSet<>(List.of("forgets", "message", "shown", "text", "compares", "later")),
        silentIn(Silent.class));
  }

  @Test
  void whoeverHandsOnIsNot() throws IOException {
    assertEquals(Set.of(), silentIn(Heard.class));
  }
}
