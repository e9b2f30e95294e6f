package urbi;

/** Functions that belong to no class: the manual's {@code urbi::convert} and such. */
public final class urbi {
  private urbi() {}

  /** See {@link UConversion#convert(UImage, UImage)}. */
  public static void convert(UImage source, UImage destination) {
    UConversion.convert(source, destination);
  }

  /** See {@link UConversion#convert(USound, USound)}. */
  public static void convert(USound source, USound destination) {
    UConversion.convert(source, destination);
  }

  /**
   * Never returns: a program of callbacks ends its {@code main} with it.
   *
   * @throws IllegalStateException when the thread is interrupted
   */
  public static void execute() {
    try {
      Thread.currentThread().join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted", e);
    }
  }

  /** Ends the process. */
  public static void exit(int status) {
    System.exit(status);
  }
}
