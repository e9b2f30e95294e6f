package org.urbi.kernel.library.reference;

import java.util.Map;
import java.util.function.Supplier;

/**
 * What {@code help} knows besides the library and the language.
 *
 * @param others texts by the names of their topics, such as {@code --port}; asked for when somebody
 *     wants to know
 */
public record Topics(Supplier<Map<String, String>> others) {}
