package examples.uobjectjava;

import urbi.UObject;

/** The least that a UObject can be. */
public class SimpleUObject extends UObject {
  static {
    UStart(SimpleUObject.class);
  }

  public SimpleUObject(String name) {
    super(name);
  }
}
