package liburbi.main;

/**
 * What a program with a main of its own imports {@code liburbi.main.*} for: {@code UStart} and
 * {@code main} of {@link urbi.UObject} (manual, "Providing a main class or not"). Components extend
 * {@link urbi.UObject} itself.
 */
public abstract class UObject extends urbi.UObject {
  private UObject() {}
}
