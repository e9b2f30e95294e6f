package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URL;
import java.net.URLClassLoader;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * The JDK has one thread by which all virtual threads get on that have waited for a lock. When it
 * must wait for such a lock itself, behind one of them, nobody gets it any more; and whoever loads
 * a class waits for locks.
 */
class WakingClassesTest {
  /** Loads the classes of the kernel once more, and knows which. */
  private static final class Loader extends URLClassLoader {
    Loader() {
      super(
          new URL[] {Inbox.class.getProtectionDomain().getCodeSource().getLocation()},
          WakingClassesTest.class.getClassLoader());
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
      if (!name.startsWith("org.urbi.kernel.")) {
        return super.loadClass(name, resolve);
      }
      synchronized (getClassLoadingLock(name)) {
        Class<?> known = findLoadedClass(name);
        return known == null ? findClass(name) : known;
      }
    }

    boolean has(String name) {
      return findLoadedClass(name) != null;
    }
  }

  @Test
  void whatWakesJobsIsLoadedBeforeThereAreAny() throws Exception {
    try (Loader loader = new Loader()) {
      Class<?> journal = loader.loadClass("org.urbi.kernel.journal.Journal");
      Class<?> inbox = loader.loadClass("org.urbi.kernel.job.Inbox");
      Class<?> threads = loader.loadClass("org.urbi.kernel.job.JobThreads");
      Object made = inbox.getConstructor(journal).newInstance(journal.getField("NONE").get(null));
      var factory = threads.getDeclaredMethod("factory", inbox);
      factory.setAccessible(true);
      factory.invoke(threads.getField("TICK_LOOP").get(null), made);
      for (String name :
          List.of("job.TickLoopThread", "job.TickLoopThread$Factory", "message.Message$Resumed")) {
        assertTrue(loader.has("org.urbi.kernel." + name), name);
      }
    }
  }
}
