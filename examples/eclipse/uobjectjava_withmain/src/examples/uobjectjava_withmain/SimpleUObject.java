package examples.uobjectjava_withmain;

import urbi.UObject;

/** Does not call UStart: {@link Main} does. */
public class SimpleUObject extends UObject {
  public SimpleUObject(String name) {
    super(name);
    UBindFunction("greet");
  }

  public String greet(String whom) {
    return "Hello, " + whom + "!";
  }
}
