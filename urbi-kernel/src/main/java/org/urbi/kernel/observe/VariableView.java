package org.urbi.kernel.observe;

import java.util.List;

/**
 * What has changed of the objects that somebody looks at.
 *
 * @param roots the names of the lobbies, and Global
 * @param objects of those that were asked for, the ones that have changed
 */
public record VariableView(List<String> roots, List<ObjectView> objects) {}
