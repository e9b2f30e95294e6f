package org.urbi.bench.jmh;

import java.util.List;
import urbi.UObject;
import urbi.UVar;

/** The UObject that is measured. */
public final class MeasuredObject extends UObject {
  private final UVar val = new UVar();
  private final UVar watched = new UVar();
  private int changes;

  public MeasuredObject(String name) {
    super(name);
    UBindVars(val, "val", watched, "watched");
    val.setValue(1);
    watched.setValue(1);
    UBindFunctions("same", "text", "sum", "add");
    UNotifyChange(watched, "changed");
  }

  public double same(double n) {
    return n;
  }

  public String text(String text) {
    return text;
  }

  public double sum(List<Double> numbers) {
    double sum = 0;
    for (double number : numbers) {
      sum += number;
    }
    return sum;
  }

  public double add(double n) {
    return val.doubleValue() + n;
  }

  public void changed(double value) {
    changes += value > 0 ? 1 : 0;
  }
}
