package urbi;

/**
 * Runs UObjects in a process of their own, connected to a server (manual, "Providing a main class
 * or not"): {@code java -cp liburbijava.jar urbi.UMain machine.jar}; {@code --help} tells more.
 */
public final class UMain {
  private UMain() {}

  /** Runs the program until the connection ends. */
  public static void main(String[] arguments) {
    System.exit(RemoteRunner.get().run(arguments, null, System.out, System.err));
  }
}
