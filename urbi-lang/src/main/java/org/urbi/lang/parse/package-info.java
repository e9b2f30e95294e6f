/** Parses texts to syntax trees. */
@NullMarked
package org.urbi.lang.parse;

import org.jspecify.annotations.NullMarked;
