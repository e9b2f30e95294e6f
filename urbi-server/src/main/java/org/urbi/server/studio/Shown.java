package org.urbi.server.studio;

import java.util.List;
import java.util.Set;

/**
 * What programs that speak Foxglove's protocol are shown, and who they may be.
 *
 * @param paths of slots that are shown besides the variables
 * @param origins the sites whose pages may be such programs
 */
public record Shown(List<String> paths, Set<String> origins) {
  /** The variables, for programs and for pages of this server alone. */
  public static final Shown VARIABLES = new Shown(List.of(), Set.of());
}
