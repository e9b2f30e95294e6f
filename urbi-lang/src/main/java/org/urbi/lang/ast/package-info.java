/** The syntax tree of urbiscript. */
package org.urbi.lang.ast;
