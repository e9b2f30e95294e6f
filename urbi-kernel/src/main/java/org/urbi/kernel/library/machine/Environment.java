package org.urbi.kernel.library.machine;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/** The variables of the environment, of one kernel and of the programs that it runs. */
public final class Environment {
  private final Map<String, String> variables;

  /**
   * @param variables at the start of the kernel
   */
  public Environment(Map<String, String> variables) {
    this.variables = new TreeMap<>(variables);
  }

  /** The variables by their names, to be read. */
  public Map<String, String> variables() {
    return Collections.unmodifiableMap(variables);
  }

  /** The value of a variable, or null. */
  @Nullable String get(String name) {
    return variables.get(name);
  }

  void set(String name, String value) {
    variables.put(name, value);
  }

  /** Removes a variable, and returns its value or null. */
  @Nullable String unset(String name) {
    return variables.remove(name);
  }
}
