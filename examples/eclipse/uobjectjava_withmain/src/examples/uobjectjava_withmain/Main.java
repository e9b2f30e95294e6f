package examples.uobjectjava_withmain;

import urbi.UObject;

/** A program of its own: it names its UObjects, and connects to the server that its arguments tell. */
public final class Main {
  private Main() {}

  /**
   * @param arguments {@code -H address -P port}; {@code --help} shows what else there is
   */
  public static void main(String[] arguments) {
    UObject.UStart(SimpleUObject.class);
    UObject.main(arguments);
  }
}
