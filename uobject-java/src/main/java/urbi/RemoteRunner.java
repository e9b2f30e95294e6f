package urbi;

import java.io.PrintStream;
import java.util.ServiceLoader;
import org.jspecify.annotations.Nullable;

/**
 * Runs UObjects in this process, connected to a server. The one that there is, is found by {@link
 * ServiceLoader}: who writes UObjects does not depend on how they talk to a server.
 */
public interface RemoteRunner {
  /**
   * Runs UObjects until the connection ends.
   *
   * @param arguments as {@link UMain} takes them
   * @param program the UObjects to be run; null for those of the jars among the arguments
   * @return the exit status of the program: 0 if the server has said good-bye
   */
  int run(String[] arguments, @Nullable UModule program, PrintStream out, PrintStream err);

  /**
   * The one that there is.
   *
   * @throws IllegalStateException if the jar of the SDK is not complete
   */
  static RemoteRunner get() {
    return ServiceLoader.load(RemoteRunner.class, RemoteRunner.class.getClassLoader())
        .findFirst()
        .orElseThrow(() ->
            new IllegalStateException(
                "META-INF/services of the SDK's jar is missing: nothing connects to a server"));
  }
}
