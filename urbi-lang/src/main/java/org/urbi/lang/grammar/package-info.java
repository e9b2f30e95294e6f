/** The ANTLR grammars of urbiscript, and what they need that a grammar cannot say. */
@NullMarked
package org.urbi.lang.grammar;

import org.jspecify.annotations.NullMarked;
