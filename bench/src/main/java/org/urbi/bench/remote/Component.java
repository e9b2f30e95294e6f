package org.urbi.bench.remote;

import urbi.UImage;
import urbi.UObject;
import urbi.UVar;

/** What the benchmark calls in the other process. */
public final class Component extends UObject {
  private final UVar v = new UVar();
  private int images;
  private long bytes;

  /** Made by the kernel. */
  public Component(String name) {
    super(name);
    UBindVar(v, "v");
    UBindFunctions("echo", "flood", "watch", "count");
  }

  /** What it was given. */
  public double echo(double value) {
    return value;
  }

  /** Sets the variable so many times. */
  public void flood(int times) {
    for (int i = 1; i <= times; i++) {
      v.setValue(i);
    }
  }

  /** Wants to know about images. */
  public void watch(String name) {
    UNotifyChange(name, "onImage");
  }

  /** Takes an image. */
  public void onImage(UImage image) {
    images++;
    bytes += image.getSize();
  }

  /** How many images have come. */
  public int count() {
    int seen = images;
    images = 0;
    return seen;
  }
}
