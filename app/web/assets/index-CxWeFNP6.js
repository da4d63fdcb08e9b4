// node_modules/preact/dist/preact.mjs
var n$1;
var t$3;
var r$2;
var u$3;
var i$2;
var f$3;
var o$3;
var e$2;
var l$2;
var c$2;
var a$3;
var h$3 = Symbol.for("pv");
var p$3 = {};
var y$3 = [];
var v$2 = /^m(i|n|o|s|text|space)$/;
var w$3 = Array.isArray;
var d$2 = y$3.slice;
var _$1 = Object.assign;
function g$3(n) {
	n && n.parentNode && n.remove();
}
function k$2(n, t, r) {
	var u, i, f, o = {}, e = arguments.length;
	for (f in t) "key" == f ? u = t[f] : "ref" == f && "function" != typeof n ? i = t[f] : o[f] = t[f];
	return e > 2 && (o.children = e > 3 ? d$2.call(arguments, 2) : r), m$3(n, o, u, i, null);
}
function m$3(r, u, i, f, o) {
	var e = {
		type: r,
		props: u,
		key: i,
		ref: f,
		__k: null,
		__: null,
		__b: 0,
		__e: null,
		__c: null,
		constructor: h$3,
		__v: o || ++t$3,
		__i: -1,
		__u: 0
	};
	return !o && n$1.vnode && n$1.vnode(e), e;
}
function $(n) {
	return n.children;
}
function x$1(n, t) {
	this.props = n, this.context = t, this.__g = 0;
}
function S$1(n, t) {
	if (null == t) return n.__ && S$1(n.__, n.__i + 1);
	for (var r; t < n.__k.length; t++) if ((r = n.__k[t]) && r.__e) return r.__e;
	return "function" != typeof n.type || n.props.__P ? null : S$1(n);
}
function C$1(t) {
	var r, u = t.__v, i = u.__e, f = [], o = [], e = t.__P;
	e && ((r = _$1({ constructor: h$3 }, u)).__v = u.__v + 1, n$1.vnode && n$1.vnode(r), z$1(e, r, u, t.__n, e.namespaceURI, 32 & u.__u ? [i] : null, f, i || S$1(u), 32 & u.__u, o), r.__v = u.__v, r.__.__k[r.__i] = r, E$1(f, r, o), u.__ = u.__e = null, r.__e != i && j$1(r));
}
function j$1(n) {
	if ((n = n.__) && n.__c && !n.props.__P) return n.__e = null, n.__k.some(function(t) {
		return t && (n.__e = t.__e);
	}), j$1(n);
}
function L(t) {
	(8 & t.__g || (t.__g |= 8, u$3.push(t), f$3++)) && i$2 == n$1.debounceRendering || ((i$2 = n$1.debounceRendering) || queueMicrotask)(H);
}
function H() {
	try {
		for (var n, t = 1; u$3.length;) u$3.length > t && u$3.sort(o$3), n = u$3.shift(), t = u$3.length, 8 & n.__g && C$1(n);
	} finally {
		(f$3 = u$3.length) && (i$2 || queueMicrotask)(H);
	}
}
function I(n, t, r, u, i, f, o, e, l, c, a) {
	var s, h, v, w, d, _, g = u.__k || y$3, k = t.length;
	for (l = q(r, t, g, l, k), s = 0; s < k; s++) null != (v = r.__k[s]) && (h = ~v.__i && g[v.__i] || p$3, v.__i = s, _ = z$1(n, v, h, i, f, o, e, l, c, a), w = v.__e, (h.ref != v.ref || 8 & h.__u) && (h.ref && G(h.ref, null, v, h), v.ref && a.push(v.ref, v.__c || w, v)), d = d || w, 4 & v.__u ? (l = A$2(v, l, n, !h.__v), h.__e && (h.__e = null)) : "function" == typeof v.type && void 0 !== _ ? l = _ : w && (l = w.nextSibling), v.__u &= -21);
	return r.__e = d, l;
}
function q(n, t, r, u, i) {
	var f, o, e, l, c, a, s, p, y, v = r.length, d = v, _ = 0, g = 0, k = n.__k = Array(i);
	for (f = 0; f < i; f++) null != (o = t[f]) && "boolean" != typeof o && "function" != typeof o ? ("object" != typeof o || o.constructor === String ? o = k[f] = m$3(null, o) : w$3(o) ? o = k[f] = m$3($, { children: o }) : o.constructor === h$3 && o.__b ? o = k[f] = m$3(o.type, o.props, o.key, o.ref, o.__v) : k[f] = o, l = f + _, o.__ = n, o.__b = n.__b + 1, e = null, ~(c = o.__i = P(o, r, l, d)) && (d--, (e = r[c]) && (e.__u |= 2)), e && e.__v ? (o.__u |= 16, c == l - 1 ? _-- : c == l + 1 ? _++ : c != l && (c > l ? _-- : _++, g = 1)) : (~c || (i > v ? _-- : i < v && _++), "function" != typeof o.type && (o.__u |= 4))) : k[f] = null;
	if (g) {
		for (a = [], s = [], f = 0; f < i; f++) if ((o = k[f]) && 16 & o.__u) {
			for (_ = 0, p = a.length; _ < p;) a[y = _ + p >> 1] < o.__i ? _ = y + 1 : p = y;
			a[_] = o.__i, s[f] = _ + 1;
		}
		for (_ = a.length; f--;) s[f] && (s[f] == _ ? _-- : k[f].__u |= 4);
	}
	if (d) for (f = 0; f < v; f++) !(e = r[f]) || 2 & e.__u || (e.__e == u && (u = S$1(e)), J(e, e));
	return u;
}
function A$2(n, t, r, u) {
	var i, f, o, e;
	if ("function" == typeof n.type) {
		if (n.props.__P) return t;
		if (i = n.__k) for (f = 0; f < i.length; f++) i[f] && (i[f].__ = n, t = A$2(i[f], t, r, !1));
		return t;
	}
	for (t && !t.parentNode && (t = S$1(n)) && !t.parentNode && (t = null), o = n.__e, e = t; e && 8 == e.nodeType;) e = e.nextSibling;
	for (o != e && (!u && r.moveBefore && o.parentNode ? r.moveBefore(o, t) : r.insertBefore(o, t || null)), t = o; (t = t && t.nextSibling) && 8 == t.nodeType && !t.data.startsWith("$s"););
	return t;
}
function P(n, t, r, u) {
	var i, f = n.key, o = n.type, e = t[r], l = e && !(2 & e.__u);
	if (null === e && null == f || l && f == e.key && o == e.type) return r;
	if (u > (l ? 1 : 0)) {
		for (i = r - 1; i >= 0; i--) if ((e = t[i]) && !(2 & e.__u) && f == e.key && o == e.type) return i;
		for (i = r + 1; i < t.length; i++) if ((e = t[i]) && !(2 & e.__u) && f == e.key && o == e.type) return i;
	}
	return -1;
}
function T$1(n, t, r) {
	r ??= "", "-" == t[0] ? n.setProperty(t, r) : n[t] = r;
}
function N(n, t, r, u, i) {
	var f, o;
	if ("style" == t) if ("string" == typeof r) n.style.cssText = r;
	else {
		if ("string" == typeof u && (n.style.cssText = u = ""), u) for (t in u) r && t in r || T$1(n.style, t);
		if (r) for (t in r) u && r[t] == u[t] || T$1(n.style, t, r[t]);
	}
	else if ("o" == t[0] && "n" == t[1]) "function" != typeof r && (r = null), "function" != typeof u && (u = null), (n.__e || (n.__e = {}))[t] = r, r && u || (o = a$3[t] || (a$3[t] = V(t)), (n.__a || (n.__a = {}))[t] = c$2, f = t != (t = t.replace(l$2, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), r ? n.addEventListener(t, o, f) : n.removeEventListener(t, o, f));
	else {
		if ("http://www.w3.org/2000/svg" == i) t = t.replace(/xlink(H|:h)/, "h").replace(/sName$/, "s");
		else if ("width" != t && "height" != t && "href" != t && "list" != t && "form" != t && "tabIndex" != t && "download" != t && "rowSpan" != t && "colSpan" != t && "role" != t && "popover" != t && t in n) try {
			n[t] = null == r ? "" : r;
			return;
		} catch (n) {}
		if ("function" == typeof r) return;
		null == r || !1 === r && "-" != t[4] ? n.removeAttribute(t) : n.setAttribute(t, "popover" == t && 1 == r ? "" : r);
	}
}
function V(t) {
	return function(r) {
		var u = this.__e;
		if (u) {
			if (u = u[t], null == r[e$2]) r[e$2] = c$2++;
			else if (r[e$2] < this.__a[t]) return;
			return u(n$1.event ? n$1.event(r) : r);
		}
	};
}
function z$1(t, r, u, i, f, o, e, l, c, a) {
	var s, p, v, d, k, b, m, M, C, j, L, H, q, A, O, P, T, N, V = r.type;
	if (r.constructor !== h$3) return null;
	128 & u.__u && (c = 32 & u.__u, s = u.__c.__z) && (r.__u |= c, p = o = [], 8 == s.nodeType ? l = B$1(s, o) : o.push(s), l = o[0] || l), (s = n$1.__b) && s(r);
	n: if ("function" == typeof V) {
		v = e.length;
		try {
			if (M = r.props, C = (s = V.prototype) && s.render, j = (s = V.contextType) && i[s.__c], L = s ? j ? j.props.value : s.__ : i, (d = u.__c) ? (r.__c = d, 2 & d.__g && (d.__g |= 1)) : (C ? r.__c = d = new V(M, L) : (r.__c = d = new x$1(M, L), d.constructor = V, d.render = K), j && j.sub(d), d.state || (d.state = {}), d.__n = i, d.__g |= 8, d.__h = [], d.__k = []), C && (d.__s || (d.__s = d.state), V.getDerivedStateFromProps && (d.__s == d.state && (d.__s = _$1({}, d.__s)), _$1(d.__s, V.getDerivedStateFromProps(M, d.__s)))), k = d.props, b = d.state, d.__v = r, u.__c) {
				if (M !== k && C && !V.getDerivedStateFromProps && d.componentWillReceiveProps && d.componentWillReceiveProps(M, L), r.__v == u.__v && !(8 & d.__g) || !(4 & d.__g) && d.shouldComponentUpdate && !1 === d.shouldComponentUpdate(M, d.__s, L)) {
					r.__v != u.__v && (d.props = M, d.state = d.__s, d.__g &= -9), r.__e = u.__e, r.__k = u.__k, r.__k.some(function(n) {
						n && (n.__ = r);
					}), y$3.push.apply(d.__h, d.__k), d.__k = [], d.__h.length && e.push(d), l = S$1(u);
					break n;
				}
				d.componentWillUpdate && d.componentWillUpdate(M, d.__s, L), C && d.componentDidUpdate && d.__h.push(function() {
					d.componentDidUpdate(k, b, m);
				});
			} else C && !V.getDerivedStateFromProps && d.componentWillMount && d.componentWillMount(), C && d.componentDidMount && d.__h.push(d.componentDidMount);
			d.context = L, d.props = M, d.__P = t, d.__g &= -5, H = n$1.__r, q = C ? 25 : 0;
			do
				d.__g &= -9, H && H(r), s = d.render(d.props, d.state = d.__s, d.context);
			while (8 & d.__g && ++q < 25);
			C && (y$3.push.apply(d.__h, d.__k), d.__k = []), d.state = d.__s, d.getChildContext && (i = _$1({}, i, d.getChildContext())), C && u.__c && d.getSnapshotBeforeUpdate && (m = d.getSnapshotBeforeUpdate(k, b)), A = s && s.type === $ && null == s.key ? s.props.children : s, M.__P && (s = l, f = (t = M.__P).namespaceURI, c = o = null, u.props && u.props.__P != t && (u.__k.some(function(n) {
				n && J(n, n);
			}), u.__k = null), l = u.__k ? S$1(u, 0) : null), l = I(t, w$3(A) ? A : [A], r, u, i, f, o, e, l, c, a), M.__P && (r.__e = null, l = s), r.__u &= -161, p && p.some(g$3), d.__h.length && e.push(d), 1 & d.__g && (d.__g &= -4);
		} catch (t) {
			if (e.length = v, r.__v = null, c || o) if (t && t.then) {
				if (r.__u |= 128 | c, o) {
					for (~(T = o.indexOf(l || void 0)) || (T = o.length); (N = o[T - 1]) && 8 == N.nodeType;) T--;
					for (; T < o.length; T++) if (N = o[T]) if (o[T] = null, O) {
						if (N == P) break;
					} else {
						if (8 != N.nodeType) break;
						N.data.startsWith("$s") && (P = B$1(O = N));
					}
				}
				if (!O) {
					for (; l && 8 == l.nodeType && l.nextSibling;) l = l.nextSibling;
					O = l;
				}
				(s = B$1(O = r.__c.__z || (r.__c.__z = O))) ? (r.__e = O, l = s) : r.__e = l, l = l && l.nextSibling;
			} else o && o.some(g$3);
			else r.__e = u.__e;
			r.__k || (r.__k = u.__k || []), t && t.then || D$1(r), n$1.__e(t, r, u);
		}
	} else l = r.__e = F$1(u.__e, r, u, i, f, o, e, c, a, t);
	return (s = n$1.diffed) && s(r), l;
}
function B$1(n, t) {
	if (n && 8 == n.nodeType && n.data.startsWith("$s")) for (var r = 1; n = n.nextSibling;) {
		if (8 == n.nodeType) {
			if (n.data.startsWith("$s")) r++;
			else if (n.data.startsWith("/$s") && !--r) return n;
		}
		t && t.push(n);
	}
}
function D$1(n) {
	n && (n.__c && (n.__c.__g |= 4), n.__k && n.__k.some(D$1));
}
function E$1(t, r, u) {
	for (var i = 0; i < u.length;) G(u[i++], u[i++], u[i++]);
	n$1.__c && n$1.__c(r, t), t.some(function(r) {
		try {
			t = r.__h, r.__h = [], t.some(function(n) {
				n.call(r);
			});
		} catch (t) {
			n$1.__e(t, r.__v);
		}
	});
}
function F$1(t, r, u, i, f, o, e, l, c, a) {
	var s, h, y, _, k, b, m, M, $ = u.props || p$3, x = r.props, C = r.type;
	if ("svg" == C ? f = "http://www.w3.org/2000/svg" : "math" == C ? f = "http://www.w3.org/1998/Math/MathML" : f || (f = "http://www.w3.org/1999/xhtml"), o) {
		for (s = 0; s < o.length; s++) if ((k = o[s]) && (C ? k.localName == C : 3 == k.nodeType)) {
			t = k, o[s] = null;
			break;
		}
	}
	if (!t) {
		if (M = a.ownerDocument || document, !C) return M.createTextNode(x);
		t = M.createElementNS(f, C, x.is ? x : a), l && (n$1.__m && n$1.__m(r, o), l = !1), o = null;
	}
	if (C) {
		if (a = "template" == C && t.content || t, o = "textarea" == C && null != x.defaultValue ? null : o && d$2.call(a.childNodes), !l && o) for ($ = {}, s = 0; s < t.attributes.length; s++) $[(k = t.attributes[s]).name] = k.value;
		for (s in $) k = $[s], "dangerouslySetInnerHTML" == s ? y = k : "children" == s || s in x || "value" == s && "defaultValue" in x || "checked" == s && "defaultChecked" in x || N(t, s, null, k, f);
		for (s in x) k = x[s], "children" == s ? _ = k : "dangerouslySetInnerHTML" == s ? h = k : "value" == s ? b = k : "checked" == s ? m = k : l && "function" != typeof k || $[s] === k || N(t, s, k, $[s], f);
		h ? (l || y && (h.__html == y.__html || h.__html == t.innerHTML) || (t.innerHTML = h.__html), r.__k = []) : (y && (t.textContent = ""), ("foreignObject" == C || "http://www.w3.org/1998/Math/MathML" == f && v$2.test(C)) && (f = "http://www.w3.org/1999/xhtml"), I(a, w$3(_) ? _ : [_], r, u, i, f, o, e, o ? o[0] : u.__k && S$1(u, 0), l, c), o && o.some(g$3)), l && "textarea" != C || (s = "value", "progress" == C && null == b ? t.removeAttribute(s) : null == b || b === t[s] && ("progress" != C || b) || N(t, s, b, $[s], f), s = "checked", null != m && m != t[s] && N(t, s, m, $[s], f));
	} else $ === x || l && t.data == x || (t.data = x);
	return t;
}
function G(t, r, u, i) {
	try {
		"function" == typeof t ? r ? r.__x = t(r) || 1 : i && (i = i.__c || i.__e) && (r = i.__x) && (i.__x = null, "function" == typeof r ? r() : t(null)) : t.current = r;
	} catch (t) {
		n$1.__e(t, u);
	}
}
function J(t, r, u) {
	var i, f, o, e;
	if (n$1.unmount && n$1.unmount(t), !(i = t.ref) || i.current && i.current != t.__e || G(i, null, r, t), i = t.__c) {
		if (i.componentWillUnmount) try {
			i.componentWillUnmount();
		} catch (t) {
			n$1.__e(t, r);
		}
		i.__P = i.__n = null;
	}
	if (i = t.__k) for (e = 0; e < i.length; e++) i[e] && J(i[e], r, "function" != typeof t.type || u && !t.props.__P);
	!u && (i = t.__c) && (i = i.__z) && (f = B$1(i, o = [])) && (i == t.__e && o.some(g$3), g$3(f), g$3(i)), u || g$3(t.__e), t.__e = t.__c = t.__ = null;
}
function K(n, t, r) {
	return this.constructor(n, r);
}
function Q(t, r) {
	var u, i, f, o;
	n$1.__ && n$1.__(t, r), 9 == r.nodeType && (r = r.documentElement), i = (u = t && 32 & t.__u) ? null : r.__k, r.__k = m$3($, { children: [t] }), f = [], o = [], z$1(r, r.__k, i || p$3, p$3, r.namespaceURI, i ? null : r.firstChild ? d$2.call(r.childNodes) : null, f, i ? i.__e : r.firstChild, u, o), E$1(f, r.__k, o), r.__k.props.children = null;
}
n$1 = { __e: function(n, t, r, u) {
	for (var i, o, e; t = t.__;) if ((i = t.__c) && !(1 & i.__g)) {
		i.__g |= 4;
		try {
			if ((e = (o = i.constructor) && o.getDerivedStateFromError) && i.setState(o.getDerivedStateFromError(n)), i.componentDidCatch && (i.componentDidCatch(n, u || {}), e = 1), e && 8 & i.__g) return void (i.__g |= 2);
		} catch (t) {
			n = t;
		}
	}
	throw f$3 = 0, n;
} }, t$3 = 0, r$2 = function(n) {
	return null != n && n.constructor === h$3;
}, x$1.prototype.setState = function(n, t) {
	var r = this.__s;
	r && r != this.state || (r = this.__s = _$1({}, this.state)), "function" == typeof n && (n = n(_$1({}, r), this.props)), n && (_$1(r, n), this.__v && (t && this.__k.push(t), L(this)));
}, x$1.prototype.forceUpdate = function(n) {
	this.__v && (this.__g |= 4, n && this.__h.push(n), L(this));
}, x$1.prototype.render = $, u$3 = [], f$3 = 0, o$3 = function(n, t) {
	return n.__v.__b - t.__v.__b;
}, e$2 = Symbol(), l$2 = /(PointerCapture)$|Capture$/i, c$2 = 0, a$3 = {};
// node_modules/preact/hooks/dist/hooks.mjs
var t$2;
var r$1;
var u$2;
var i$1;
var o$2 = Object.is;
var f$2 = 0;
var c$1 = [];
var e$1 = [];
var a$2 = n$1;
var v$1 = a$2.__b;
var l$1 = a$2.__r;
var m$2 = a$2.diffed;
var h$2 = a$2.__c;
var s$1 = a$2.unmount;
var p$2 = a$2.__;
function y$2(n, t) {
	a$2.__h && a$2.__h(r$1, n, f$2 || t), f$2 = 0;
	var u = r$1.__H || (r$1.__H = {
		__: [],
		__h: []
	});
	return n >= u.__.length && u.__.push({}), u.__[n];
}
function A$1(n, u) {
	var i = y$2(t$2++, 3);
	!a$2.__s && E(i.__H, u) && (i.__P = !0, i.__ = n, i.u = u, r$1.__H.__h.push(i));
}
function T(n) {
	return f$2 = 5, w$2(function() {
		return { current: n };
	}, []);
}
function w$2(n, r) {
	var u = y$2(t$2++, 7);
	return E(u.__H, r) && (u.__ = n(), u.__H = r), u.__;
}
function g$2() {
	var n;
	do {
		for (; n = e$1.shift();) try {
			C(n);
		} catch (t) {
			a$2.__e(t, { __: (n = n.__P) && n.__v });
		}
		for (; n = c$1.shift();) {
			var t = n.__H;
			if (n.__P && t) try {
				t.__h.some(C), t.__h.some(D), t.__h = [];
			} catch (r) {
				t.__h = [], a$2.__e(r, n.__v);
			}
		}
	} while (e$1.length);
}
a$2.__b = function(n) {
	r$1 = null, v$1 && v$1(n);
}, a$2.__ = function(n, t) {
	n && t.__k && t.__k.__m && (n.__m = t.__k.__m), p$2 && p$2(n, t);
}, a$2.__r = function(n) {
	l$1 && l$1(n), t$2 = 0;
	var i = (r$1 = n.__c).__H;
	i && (u$2 == r$1 ? r$1.__h = [] : (i.__h.some(C), i.__h.some(D), t$2 = 0), i.__h = [], i.__.some(function(n) {
		n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
	})), u$2 = r$1;
}, a$2.diffed = function(n) {
	m$2 && m$2(n);
	var t = n.__c;
	t && t.__H && (t.__H.__h.length && B(c$1.push(t)), t.__H.__.some(function(n) {
		n.u && (n.__H = n.u);
	})), u$2 = r$1 = null;
}, a$2.__c = function(n, t) {
	t.some(function(n) {
		try {
			n.__h.some(C), n.__h = n.__h.filter(function(n) {
				return !n.__ || D(n);
			});
		} catch (t) {
			n.__h = [function() {
				throw t;
			}];
		}
	}), h$2 && h$2(n, t);
}, a$2.unmount = function(n) {
	s$1 && s$1(n);
	var t, r, u = n.__c;
	u && u.__H && (u.__H.__.some(function(u) {
		try {
			if (u.__P && u.__c) {
				if (void 0 === r) {
					for (r = n.__; r && (!r.__c || !r.__c.__P);) r = r.__;
					r = r && r.__c;
				}
				u.__P = r, B(e$1.push(u));
			} else C(u);
		} catch (n) {
			t = n;
		}
	}), u.__H = void 0, t && a$2.__e(t, u.__v));
};
var k$1 = "function" == typeof requestAnimationFrame;
function z(n) {
	var t, r = function() {
		clearTimeout(u), k$1 && cancelAnimationFrame(t), setTimeout(n);
	}, u = setTimeout(r, 35);
	k$1 && (t = requestAnimationFrame(r));
}
function B(n) {
	1 != n && i$1 == a$2.requestAnimationFrame || ((i$1 = a$2.requestAnimationFrame) || z)(g$2);
}
function C(n) {
	var t = r$1, u = n.__c;
	"function" == typeof u && (n.__c = void 0, u()), r$1 = t;
}
function D(n) {
	var t = r$1;
	n.__c = n.__(), r$1 = t;
}
function E(n, t) {
	return !n || n.length != t.length || t.some(function(t, r) {
		return !o$2(t, n[r]);
	});
}
// node_modules/@preact/signals-core/dist/signals-core.module.js
var i = Symbol.for("preact-signals");
function t$1() {
	if (!(v > 1)) {
		var i, t = !1;
		(function() {
			var i = c;
			c = void 0;
			while (void 0 !== i) {
				var t = i.S;
				if (t.v === i.v) {
					for (var r = t.t; void 0 !== r; r = r.x) if (r.i === i.i) r.i = t.i;
				}
				i = i.o;
			}
		})();
		while (void 0 !== h$1) {
			var r = h$1;
			h$1 = void 0;
			s++;
			while (void 0 !== r) {
				var n = r.u;
				r.u = void 0;
				r.f &= -3;
				if (!(8 & r.f) && w$1(r)) try {
					r.c();
				} catch (r) {
					if (!t) {
						i = r;
						t = !0;
					}
				}
				r = n;
			}
		}
		s = 0;
		v--;
		if (t) throw i;
	} else v--;
}
function r(i) {
	if (v > 0) return i();
	u$1 = ++e;
	v++;
	try {
		return i();
	} finally {
		t$1();
	}
}
var n;
var o$1 = void 0;
function f$1(i) {
	var t = o$1, r = n;
	o$1 = void 0;
	n = void 0;
	try {
		return i();
	} finally {
		o$1 = t;
		n = r;
	}
}
var h$1 = void 0;
var v = 0;
var s = 0;
var e = 0;
var u$1 = 0;
var c = void 0;
var a$1 = 0;
function d$1(i) {
	if (void 0 !== o$1) {
		var t = i.n;
		if (void 0 === t || t.t !== o$1) {
			t = {
				i: 0,
				S: i,
				p: o$1.s,
				n: void 0,
				t: o$1,
				e: void 0,
				x: void 0,
				r: t
			};
			if (void 0 !== o$1.s) o$1.s.n = t;
			o$1.s = t;
			i.n = t;
			if (32 & o$1.f) i.S(t);
			return t;
		} else if (-1 === t.i) {
			t.i = 0;
			if (void 0 !== t.n) {
				t.n.p = t.p;
				if (void 0 !== t.p) t.p.n = t.n;
				t.p = o$1.s;
				t.n = void 0;
				o$1.s.n = t;
				o$1.s = t;
			}
			return t;
		}
	}
}
function l(i, t) {
	this.v = i;
	this.i = 0;
	this.n = void 0;
	this.t = void 0;
	this.l = 0;
	this.W = null == t ? void 0 : t.watched;
	this.Z = null == t ? void 0 : t.unwatched;
	this.name = null == t ? void 0 : t.name;
}
l.prototype.brand = i;
l.prototype.h = function() {
	return !0;
};
l.prototype.S = function(i) {
	var t = this, r = this.t;
	if (r !== i && void 0 === i.e) {
		i.x = r;
		this.t = i;
		if (void 0 !== r) r.e = i;
		else f$1(function() {
			var i;
			null == (i = t.W) || i.call(t);
		});
	}
};
l.prototype.U = function(i) {
	var t = this;
	if (void 0 !== this.t) {
		var r = i.e, n = i.x;
		if (void 0 !== r) {
			r.x = n;
			i.e = void 0;
		}
		if (void 0 !== n) {
			n.e = r;
			i.x = void 0;
		}
		if (i === this.t) {
			this.t = n;
			if (void 0 === n) f$1(function() {
				var i;
				null == (i = t.Z) || i.call(t);
			});
		}
	}
};
l.prototype.subscribe = function(i) {
	var t = this;
	return x(function() {
		var r = t.value;
		f$1(function() {
			return i(r);
		});
	}, { name: "sub" });
};
l.prototype.valueOf = function() {
	return this.value;
};
l.prototype.toString = function() {
	return this.value + "";
};
l.prototype.toJSON = function() {
	return this.value;
};
l.prototype.peek = function() {
	var i = this;
	return f$1(function() {
		return i.value;
	});
};
Object.defineProperty(l.prototype, "value", {
	get: function() {
		var i = d$1(this);
		if (void 0 !== i) i.i = this.i;
		return this.v;
	},
	set: function(i) {
		if (i !== this.v) {
			if (s > 100) throw new Error("Cycle detected");
			(function(i) {
				if (0 !== v && 0 === s) {
					if (i.l !== u$1) {
						i.l = u$1;
						c = {
							S: i,
							v: i.v,
							i: i.i,
							o: c
						};
					}
				}
			})(this);
			this.v = i;
			this.i++;
			a$1++;
			v++;
			try {
				for (var r = this.t; void 0 !== r; r = r.x) r.t.N();
			} finally {
				t$1();
			}
		}
	}
});
function y$1(i, t) {
	return new l(i, t);
}
function w$1(i) {
	for (var t = i.s; void 0 !== t; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return !0;
	return !1;
}
function b$1(i) {
	for (var t = i.s; void 0 !== t; t = t.n) {
		var r = t.S.n;
		if (void 0 !== r) t.r = r;
		t.S.n = t;
		t.i = -1;
		if (void 0 === t.n) {
			i.s = t;
			break;
		}
	}
}
function _(i) {
	var t = i.s, r = void 0;
	while (void 0 !== t) {
		var n = t.p;
		if (-1 === t.i) {
			t.S.U(t);
			if (void 0 !== n) n.n = t.n;
			if (void 0 !== t.n) t.n.p = n;
		} else r = t;
		t.S.n = t.r;
		if (void 0 !== t.r) t.r = void 0;
		t = n;
	}
	i.s = r;
}
function j(i, t) {
	l.call(this, void 0, t);
	this.x = i;
	this.s = void 0;
	this.g = a$1 - 1;
	this.f = 4;
}
j.prototype = new l();
j.prototype.h = function() {
	this.f &= -3;
	if (1 & this.f) return !1;
	if (32 == (36 & this.f)) return !0;
	this.f &= -5;
	if (this.g === a$1) return !0;
	this.g = a$1;
	this.f |= 1;
	if (this.i > 0 && !w$1(this)) {
		this.f &= -2;
		return !0;
	}
	var i = o$1;
	try {
		b$1(this);
		o$1 = this;
		var t = this.x();
		if (16 & this.f || this.v !== t || 0 === this.i) {
			this.v = t;
			this.f &= -17;
			this.i++;
		}
	} catch (i) {
		this.v = i;
		this.f |= 16;
		this.i++;
	}
	o$1 = i;
	_(this);
	this.f &= -2;
	return !0;
};
j.prototype.S = function(i) {
	if (void 0 === this.t) {
		this.f |= 36;
		for (var t = this.s; void 0 !== t; t = t.n) t.S.S(t);
	}
	l.prototype.S.call(this, i);
};
j.prototype.U = function(i) {
	if (void 0 !== this.t) {
		l.prototype.U.call(this, i);
		if (void 0 === this.t) {
			this.f &= -33;
			for (var t = this.s; void 0 !== t; t = t.n) t.S.U(t);
		}
	}
};
j.prototype.N = function() {
	if (!(2 & this.f)) {
		this.f |= 6;
		for (var i = this.t; void 0 !== i; i = i.x) i.t.N();
	}
};
Object.defineProperty(j.prototype, "value", { get: function() {
	if (1 & this.f) throw new Error("Cycle detected");
	var i = d$1(this);
	this.h();
	if (void 0 !== i) i.i = this.i;
	if (16 & this.f) throw this.v;
	return this.v;
} });
function O(i, t) {
	return new j(i, t);
}
function p$1(i) {
	var r = i.j;
	i.j = void 0;
	if ("function" == typeof r) {
		v++;
		var n = o$1;
		o$1 = void 0;
		try {
			r();
		} catch (t) {
			i.f &= -2;
			i.f |= 8;
			g$1(i);
			throw t;
		} finally {
			o$1 = n;
			t$1();
		}
	}
}
function g$1(i) {
	for (var t = i.s; void 0 !== t; t = t.n) t.S.U(t);
	i.x = void 0;
	i.s = void 0;
	p$1(i);
}
function S(i) {
	if (o$1 !== this) throw new Error("Out-of-order effect");
	_(this);
	o$1 = i;
	this.f &= -2;
	try {
		if (8 & this.f) g$1(this);
	} finally {
		t$1();
	}
}
function m$1(i, t) {
	this.x = i;
	this.j = void 0;
	this.s = void 0;
	this.u = void 0;
	this.f = 32;
	this.name = null == t ? void 0 : t.name;
	if (n) n.push(this);
}
m$1.prototype.c = function() {
	var i = this.S();
	try {
		if (8 & this.f) return;
		if (void 0 === this.x) return;
		var t = this.x();
		if ("function" == typeof t) this.j = t;
	} finally {
		i();
	}
};
m$1.prototype.S = function() {
	if (1 & this.f) throw new Error("Cycle detected");
	this.f |= 1;
	this.f &= -9;
	p$1(this);
	b$1(this);
	v++;
	var i = o$1;
	o$1 = this;
	return S.bind(this, i);
};
m$1.prototype.N = function() {
	if (!(2 & this.f)) {
		this.f |= 2;
		this.u = h$1;
		h$1 = this;
	}
};
m$1.prototype.d = function() {
	this.f |= 8;
	if (!(1 & this.f)) g$1(this);
};
m$1.prototype.dispose = function() {
	this.d();
};
function x(i, t) {
	var r = new m$1(i, t);
	try {
		r.c();
	} catch (i) {
		r.d();
		throw i;
	}
	var n = r.d.bind(r);
	n[Symbol.dispose] = n;
	return n;
}
// node_modules/@preact/signals/dist/signals.module.js
var h;
var p;
var m = "undefined" != typeof window && !!window.__PREACT_SIGNALS_DEVTOOLS__;
var g = [];
x(function() {
	h = this.N;
})();
function b(i, n) {
	n$1[i] = n.bind(null, n$1[i] || function() {});
}
function y(i) {
	if (p) {
		var n = p;
		p = void 0;
		n();
	}
	p = i && i.S();
}
function w(i) {
	var n = this, r = i.data, t = useSignal(r);
	t.name = "ReactiveDom";
	t.value = r;
	var e = w$2(function() {
		var i = n, r = n.__v;
		while (r = r.__) if (r.__c) {
			r.__c.__$f |= 4;
			break;
		}
		var o = O(function() {
			var i = t.value.value;
			return 0 === i ? 0 : !0 === i ? "" : i || "";
		}), e = O(function() {
			return !Array.isArray(o.value) && !r$2(o.value);
		}), u = x(function() {
			this.N = M;
			if (e.value) {
				var n = o.value;
				if (i.__v && i.__v.__e && 3 === i.__v.__e.nodeType) i.__v.__e.data = n;
			}
		}), c = n.__$u.d;
		n.__$u.d = function() {
			u();
			c.call(this);
		};
		return [e, o];
	}, []), u = e[0], c = e[1];
	return u.value ? c.peek() : c.value;
}
w.displayName = "ReactiveTextNode";
Object.defineProperties(l.prototype, {
	constructor: {
		configurable: !0,
		value: k$2($, null).constructor
	},
	type: {
		configurable: !0,
		value: w
	},
	props: {
		configurable: !0,
		get: function() {
			var i = this;
			return { data: { get value() {
				return i.value;
			} } };
		}
	},
	__b: {
		configurable: !0,
		value: 1
	}
});
b("__b", function(i, n) {
	y();
	if ("string" == typeof n.type) {
		var r, t = n.props;
		for (var f in t) if ("children" !== f) {
			var o = t[f];
			if (o instanceof l) {
				if (!r) n.__np = r = {};
				r[f] = o;
				t[f] = o.peek();
			}
		}
	}
	i(n);
});
b("__r", function(i, r) {
	i(r);
	if (r.type !== $) {
		y();
		var t, f = r.__c;
		if (f) {
			f.__$f &= -2;
			if (void 0 === (t = f.__$u)) f.__$u = t = function(i, n) {
				var r;
				x(function() {
					r = this;
				}, { name: n });
				r.c = i;
				return r;
			}(function(i) {
				return function() {
					var n;
					if (m) null == (n = this.y) || n.call(this);
					i.__$f |= 1;
					i.setState({});
				};
			}(f), "function" == typeof r.type ? r.type.displayName || r.type.name : "");
		}
		y(t);
	}
});
b("__e", function(i, n, r, t) {
	y();
	i(n, r, t);
});
b("diffed", function(i, n) {
	y();
	var r;
	if ("string" == typeof n.type && (r = n.__e)) {
		var t = n.__np, f = n.props, o = r.U;
		if (o) for (var e in o) {
			var u = o[e];
			if (!(void 0 === u || t && e in t)) {
				u.d();
				o[e] = void 0;
			}
		}
		if (t) {
			if (!o) {
				o = {};
				r.U = o;
			}
			for (var a in t) {
				var c = o[a], v = t[a];
				if (void 0 === c) {
					c = k(r, a, v, f);
					o[a] = c;
				} else c.o(v, f);
			}
		}
	}
	i(n);
});
function k(i, n, r, t) {
	var f = n in i && void 0 === i.ownerSVGElement, o = y$1(r);
	return {
		o: function(i, n) {
			o.value = i;
			t = n;
		},
		d: x(function() {
			this.N = M;
			var r = o.value.value;
			if (t[n] !== r) {
				t[n] = r;
				if (f) i[n] = r;
				else if (null != r && (!1 !== r || "-" === n[4])) i.setAttribute(n, r);
				else i.removeAttribute(n);
			}
		})
	};
}
b("unmount", function(i, n) {
	if ("string" == typeof n.type) {
		var r = n.__e;
		if (r) {
			var t = r.U;
			if (t) {
				r.U = void 0;
				for (var f in t) {
					var o = t[f];
					if (o) o.d();
				}
			}
		}
		var e = n.__np;
		if (e) {
			var u = n.props;
			for (var a in e) u[a] = e[a];
		}
		n.__np = void 0;
	} else {
		var c = n.__c;
		if (c) {
			c.__$f |= 8;
			var v = c.__$u;
			if (v) {
				c.__$u = void 0;
				v.d();
			}
		}
	}
	i(n);
});
b("__h", function(i, n, r, t) {
	if (t < 3) n.__$f |= 2;
	i(n, r, t);
});
x$1.prototype.shouldComponentUpdate = function(i, n) {
	if (this.__R) return !0;
	var r = this.__$u, t = r && void 0 !== r.s;
	for (var f in n) return !0;
	if (this.__f || "boolean" == typeof this.u && !0 === this.u) {
		var o = 2 & this.__$f;
		if (!(t || o || 4 & this.__$f)) return !0;
		if (1 & this.__$f) return !0;
	} else {
		if (!(t || 4 & this.__$f)) return !0;
		if (3 & this.__$f) return !0;
	}
	for (var e in i) if ("__source" !== e && i[e] !== this.props[e]) return !0;
	for (var u in this.props) if (!(u in i)) return !0;
	return !1;
};
function useSignal(i, n) {
	return w$2(function() {
		return y$1(i, n);
	}, []);
}
var A = function(i) {
	queueMicrotask(function() {
		queueMicrotask(i);
	});
};
function F() {
	r(function() {
		var i;
		while (i = g.shift()) h.call(i);
	});
}
function M() {
	if (1 === g.push(this)) (n$1.requestAnimationFrame || A)(F);
}
// src/alarms.ts
function wrongs({ controller, vehicles, devices, drives }) {
	return [
		...controller ? ofController(controller) : [],
		...[...vehicles].flatMap(ofVehicle),
		...[...devices].flatMap(ofDevice),
		...[...drives].flatMap(ofDrive)
	].sort((a, b) => Number(b.grave) - Number(a.grave) || (b.since ?? "").localeCompare(a.since ?? ""));
}
function ofController(controller) {
	const of = (key, cause, since = null) => ({
		key: `controller ${key}`,
		source: controller.plant,
		kind: "controller",
		grave: true,
		cause,
		remedy: "",
		since
	});
	return [
		...controller.trouble ? [of("trouble", controller.trouble)] : [],
		...controller.emergencies.map((words) => of(words, words)),
		...controller.circles.map((words) => of(words, words))
	];
}
function ofVehicle(vehicle) {
	const { hold, lockout, link } = vehicle;
	const of = (grave, cause, remedy, since) => ({
		key: `vehicle ${vehicle.id}`,
		source: vehicle.id,
		kind: "vehicle",
		grave,
		cause,
		remedy,
		since
	});
	if (vehicle.oper === "alarm") return [of(true, [vehicle.code ? `0x${vehicle.code.toString(16).toUpperCase().padStart(4, "0")} ${vehicle.code_name}`.trim() : "", hold?.reason].filter(Boolean).join(": ") || "alarm", hold?.remedy ?? "", hold?.since ?? null)];
	if (lockout) return [of(false, `locked out by ${lockout.owner}: ${lockout.reason}`, "", lockout.since)];
	if (hold) return [of(false, hold.reason, hold.remedy, hold.since)];
	return link.up || vehicle.activity === "off_rail" ? [] : [of(false, `it is not connected: ${link.reason}`, "", link.since)];
}
function ofDevice(device) {
	const cause = device.alarm || device.contradiction;
	if (!cause) return [];
	return [{
		key: `device ${device.id}`,
		source: device.id,
		kind: "device",
		grave: Boolean(device.alarm),
		cause,
		remedy: device.remedy,
		since: device.since
	}];
}
function ofDrive(drive) {
	const of = (grave, cause) => [{
		key: `drive ${drive.id}`,
		source: drive.id,
		kind: "drive",
		grave,
		cause,
		remedy: drive.remedy,
		since: drive.seen
	}];
	if (drive.online && drive.mode === "error") return of(true, drive.error || drive.meaning);
	return drive.online === false ? of(false, drive.reason) : [];
}
// src/api.ts
/** REST: who asks, with which key, and what the server says when it does not want to. */
/** A refusal of the server (RFC 9457), or of the network. */
var Refused = class extends Error {
	status;
	remedy;
	field;
	constructor(status, message, remedy = "", field = "") {
		super(message);
		this.status = status;
		this.remedy = remedy;
		this.field = field;
	}
};
var KEY = "hoistway.key";
var ACTOR = "hoistway.actor";
var TIMEOUT = 35e3;
var key$1 = sessionStorage.getItem(KEY) ?? "";
var wantsKey = () => void 0;
/** Server's clock minus ours, ms, from the Date header (whole seconds). */
var skew = 0;
function onKeyWanted(call) {
	wantsKey = call;
}
function useKey(given) {
	key$1 = given;
	sessionStorage.setItem(KEY, given);
}
function hasKey() {
	return key$1 !== "";
}
function actor() {
	return localStorage.getItem(ACTOR) ?? "";
}
function nameActor(name) {
	localStorage.setItem(ACTOR, name.trim());
}
/** The server's time, ms. */
function serverNow() {
	return Date.now() + skew;
}
/** A header carries bytes; the server reads them as UTF-8. */
function headerText(text) {
	return String.fromCharCode(...new TextEncoder().encode(text));
}
async function call(method, path, body, extra = {}) {
	const headers = {
		Accept: "application/json",
		...extra
	};
	if (key$1) headers["Authorization"] = `Bearer ${headerText(key$1)}`;
	if (method !== "GET" && actor()) headers["X-Actor"] = headerText(actor());
	if (body !== void 0) headers["Content-Type"] = "application/json";
	const init = {
		method,
		headers,
		signal: AbortSignal.timeout(TIMEOUT)
	};
	if (body !== void 0) init.body = JSON.stringify(body);
	let response;
	try {
		response = await fetch(`/api/v1${path}`, init);
	} catch {
		throw new Refused(0, "The server does not answer.");
	}
	const date = Date.parse(response.headers.get("date") ?? "");
	if (Math.abs(date + 500 - serverNow()) > 1500) skew = date + 500 - Date.now();
	if (response.ok) return response.status === 204 ? void 0 : await response.json();
	throw await refusal(response);
}
async function refusal(response) {
	if (response.status === 401) wantsKey();
	const problem = await response.json().catch(() => ({}));
	const text = (name) => typeof problem[name] === "string" ? problem[name] : "";
	return new Refused(response.status, text("detail") || text("title") || `${response.status} ${response.statusText}`, text("remedy"), text("field"));
}
var get = (path) => call("GET", path);
var post = (path, body, extra) => call("POST", path, body, extra);
async function alive() {
	try {
		return (await fetch("/healthz", {
			signal: AbortSignal.timeout(3e3),
			cache: "no-store"
		})).ok;
	} catch {
		return false;
	}
}
/** A name for an order that may be sent again. randomUUID exists on secure pages only. */
function freshKey() {
	const bytes = crypto.getRandomValues(/* @__PURE__ */ new Uint8Array(12));
	return `page-${Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("")}`;
}
// src/ends.ts
var worldOfKind = (kind) => kind === "agv_buffer" ? "agv" : "hoist";
/** Who serves a station, or what a vehicle is; null: there is none of that name. */
function worldOf(layout, id) {
	const station = layout?.stations.find((one) => one.id === id);
	if (station) return worldOfKind(station.kind);
	const vehicle = layout?.vehicles.find((one) => one.id === id);
	return vehicle ? vehicle.kind === "agv" ? "agv" : "hoist" : null;
}
/** Whether a job can go from one to the other; what is not chosen yet forbids nothing. */
function joins(layout, source, destination) {
	const [from, to] = [worldOf(layout, source), worldOf(layout, destination)];
	return from === null || to === null || from === to;
}
// src/live.ts
/** Takes frames in order; tells when a number is missing, or when the server has begun another history. */
var Stream = class {
	sink;
	seq = null;
	/** Number of the last event taken, null before the first snapshot. */
	lastEvent = null;
	constructor(sink) {
		this.sink = sink;
	}
	/** A new connection starts with its own snapshot and numbers. */
	restart() {
		this.seq = null;
	}
	/** Takes a message; returns what to do about it. */
	take(text) {
		const frame = JSON.parse(text);
		switch (frame.type) {
			case "snapshot": return this.snapshot(frame);
			case "change": return this.change(frame);
			case "event":
				this.events(frame.events ?? []);
				return null;
			case "resync":
				this.seq = null;
				return null;
			case "error":
				this.sink.problem(frame.problem?.detail ?? "The server refused the live stream.");
				return null;
			default: return null;
		}
	}
	snapshot(frame) {
		const last = frame.last_event ?? 0;
		const anew = this.lastEvent !== null && last < this.lastEvent;
		if (anew) this.sink.forget();
		this.seq = frame.seq ?? 0;
		this.sink.snapshot(frame.objects ?? {}, last);
		if (anew || this.lastEvent === null) this.lastEvent = last;
		return anew ? "reconnect" : null;
	}
	change(frame) {
		if (this.seq === null) return null;
		if (frame.seq !== this.seq + 1) {
			this.seq = null;
			return { say: JSON.stringify({ resync: true }) };
		}
		this.seq = frame.seq;
		for (const { topic, key, value } of frame.changes ?? []) this.sink.change(topic, key, value);
		this.sink.changed();
		return null;
	}
	events(events) {
		const news = events.filter((event) => this.lastEvent === null || event.seq > this.lastEvent);
		const last = news.at(-1);
		if (last === void 0) return;
		this.lastEvent = last.seq;
		this.sink.events(news);
	}
};
var PAUSES = [
	300,
	1e3,
	2e3,
	4e3
];
/** Silence on a quiet plant is normal; after this many ms we ask the server whether it is still there. */
var SILENCE = 1e4;
/** Keeps one stream open, for ever. */
var Watcher = class {
	stream;
	door;
	socket = null;
	failures = 0;
	heard = Date.now();
	timer = 0;
	constructor(stream, door) {
		this.stream = stream;
		this.door = door;
		window.setInterval(() => void this.listen(), SILENCE / 2);
		window.addEventListener("online", () => this.again(0));
	}
	async open() {
		window.clearTimeout(this.timer);
		if (this.socket) return;
		let address = null;
		try {
			address = await this.door.address(this.stream.lastEvent);
		} catch {
			this.again();
			return;
		}
		if (address === null || this.socket) return;
		const socket = new WebSocket(address);
		this.socket = socket;
		this.stream.restart();
		socket.onmessage = (message) => this.take(socket, String(message.data));
		socket.onclose = () => this.closed(socket);
	}
	take(socket, text) {
		if (socket !== this.socket) return;
		this.heard = Date.now();
		this.failures = 0;
		const answer = this.stream.take(text);
		if (answer === "reconnect") {
			this.socket = null;
			socket.close();
			this.again(0);
			return;
		}
		if (answer) socket.send(answer.say);
		this.door.state("live");
	}
	closed(socket) {
		if (socket !== this.socket) return;
		this.socket = null;
		this.again();
	}
	again(pause) {
		if (this.socket) return;
		this.door.state("lost");
		window.clearTimeout(this.timer);
		const wait = pause ?? PAUSES[Math.min(this.failures++, PAUSES.length - 1)];
		this.timer = window.setTimeout(() => void this.open(), wait);
	}
	async listen() {
		const socket = this.socket;
		if (!socket || socket.readyState !== WebSocket.OPEN || Date.now() - this.heard < SILENCE) return;
		if (await this.door.alive()) this.heard = Date.now();
		else if (socket === this.socket) {
			this.socket = null;
			socket.close();
			this.again();
		}
	}
};
// src/shows.ts
/** As custom properties of the style sheet, which has them for each theme. */
var LOOKS = {
	idle: "var(--look-idle)",
	moving: "var(--look-moving)",
	waiting: "var(--look-waiting)",
	handling: "var(--look-handling)",
	charging: "var(--look-charging)",
	held: "var(--look-held)",
	alarm: "var(--look-alarm)",
	gone: "var(--look-gone)"
};
var LOOK_OF = {
	idle: "idle",
	moving: "moving",
	waiting: "waiting",
	busy: "waiting",
	paused: "waiting",
	acquiring: "handling",
	depositing: "handling",
	charging: "charging",
	settling: "held",
	held: "held",
	locked_out: "held",
	recovering: "held",
	alarm: "alarm",
	absent: "gone",
	off_rail: "gone"
};
function lookOf(vehicle) {
	if (vehicle.oper === "alarm" && vehicle.activity !== "absent") return "alarm";
	const look = LOOK_OF[vehicle.activity] ?? "idle";
	return look === "idle" && !vehicle.link.up ? "gone" : look;
}
var DEVICE_LOOKS = {
	open: "var(--device-open)",
	closed: "var(--device-closed)",
	cart: "var(--device-cart)",
	no_cart: "var(--device-no_cart)",
	charging: "var(--device-charging)",
	free: "var(--device-free)",
	busy: "var(--device-busy)",
	unknown: "var(--device-unknown)",
	error: "var(--device-error)",
	silent: "var(--device-silent)"
};
/** How a door or buffer looks: what it said counts only while it is heard. A charger says nothing itself. */
function lookOfDevice(device, charging = false) {
	if (device?.kind === "charger") return charging || device.vehicles?.length ? "charging" : "free";
	if (!device?.fresh) return "silent";
	const state = device.state ?? "unknown";
	return Object.hasOwn(DEVICE_LOOKS, state) ? state : "unknown";
}
var MODES = {
	parameter_select: 0,
	parameter_value: 0,
	monitoring: 0,
	jog: 0,
	error: 0
};
/** The sign beside a name for what colour alone does not say: an alarm, or that nobody knows. */
function signOfDevice(device, look) {
	if (device?.alarm || look === "error") return "!";
	return look === "unknown" || look === "silent" ? "?" : look === "busy" ? "…" : "";
}
/** Its colour, or that of an alarm. */
function colourOfDevice(device, look) {
	return DEVICE_LOOKS[device?.alarm ? "error" : look];
}
/** What a drive does, in one word: that of its mode, or why there is none. */
function lookOfDrive(drive) {
	if (drive.online === null) return {
		word: "not_heard",
		tone: "wait"
	};
	if (!drive.online) return {
		word: "offline",
		tone: "bad"
	};
	if (drive.mode === null) return {
		word: "online",
		tone: "calm"
	};
	const tone = drive.mode === "error" ? "bad" : drive.mode === "jog" ? "go" : drive.mode === "monitoring" ? "good" : "calm";
	return {
		word: Object.hasOwn(MODES, drive.mode) ? drive.mode : "online",
		tone
	};
}
/** A distance in hundredths, as people read it. */
function hundredths(distance) {
	return (distance / 100).toFixed(2);
}
var TONES = {
	queued: "calm",
	waiting: "wait",
	transferring: "go",
	paused: "wait",
	cancelling: "wait",
	aborting: "wait",
	completed: "good",
	failed: "bad",
	cancelled: "calm",
	aborted: "bad"
};
/** 7 s, 3:05, 1:02:10, 3 d. */
function span(ms) {
	const s = Math.max(0, Math.floor(ms / 1e3));
	const two = (n) => String(n).padStart(2, "0");
	if (s < 60) return `${s} s`;
	if (s < 3600) return `${Math.floor(s / 60)}:${two(s % 60)}`;
	if (s < 86400) return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
	return `${Math.floor(s / 86400)} d`;
}
function elapsed(job, now) {
	return span((job.ended ? Date.parse(job.ended) : now) - Date.parse(job.created));
}
/** Time of day at this place. */
function clock(iso) {
	const at = new Date(iso);
	return Number.isNaN(at.getTime()) ? "" : at.toLocaleTimeString("en-GB", { hour12: false });
}
/** VehicleAcquireStarted -> Vehicle acquire started. */
function sentence(event) {
	const words = event.replace(/([a-z])([A-Z])/g, "$1 $2").toLowerCase();
	return words.charAt(0).toUpperCase() + words.slice(1);
}
// src/grid.ts
/** Things by where they are, in squares: whoever looks for neighbours need not look at all. Pure. */
var CELL$1 = 5e3;
var Grid = class {
	cells = /* @__PURE__ */ new Map();
	put(thing) {
		const key = keyOf$2(Math.floor(thing.x / CELL$1), Math.floor(thing.y / CELL$1));
		const there = this.cells.get(key);
		if (there) there.push(thing);
		else this.cells.set(key, [thing]);
	}
	/** All within a distance to either side, and some more. */
	*around(x, y, reach) {
		const to = (value) => Math.floor(value / CELL$1);
		for (let i = to(x - reach); i <= to(x + reach); i++) for (let j = to(y - reach); j <= to(y + reach); j++) yield* this.cells.get(keyOf$2(i, j)) ?? [];
	}
};
/** One number for two: fabs are a few hundred squares wide. */
var keyOf$2 = (i, j) => (i + 32768) * 65536 + (j + 32768);
// src/track.ts
/** The track as drawn: edges as curves, places along them, and the way between two barcodes. Pure. */
var STEPS$1 = 8;
var minus = (a, b) => ({
	x: a.x - b.x,
	y: a.y - b.y
});
var unit = (v) => {
	const size = Math.hypot(v.x, v.y) || 1;
	return {
		x: v.x / size,
		y: v.y / size
	};
};
var dot = (a, b) => a.x * b.x + a.y * b.y;
var Track = class {
	points = /* @__PURE__ */ new Map();
	ways = /* @__PURE__ */ new Map();
	next = /* @__PURE__ */ new Map();
	before = /* @__PURE__ */ new Map();
	/** Barcodes on the floor: tape of AGVs, and all that hangs together with it. */
	floor;
	box;
	/** Barcodes by where they are. */
	grid = new Grid();
	from = /* @__PURE__ */ new Map();
	constructor(layout) {
		for (const { barcode, x, y, park } of layout.points) {
			this.points.set(barcode, {
				x,
				y,
				park
			});
			this.grid.put({
				x,
				y
			});
		}
		for (const edge of layout.edges) {
			if (!this.points.has(edge.start) || !this.points.has(edge.end)) continue;
			push(this.next, edge.start, edge);
			push(this.before, edge.end, edge);
		}
		for (const edges of this.next.values()) for (const edge of edges) {
			const way = this.draw(edge);
			this.ways.set(keyOf$1(edge), way);
			push(this.from, edge.start, way);
		}
		this.floor = this.connected([...layout.stations.filter((station) => station.kind === "agv_buffer").map((station) => station.barcode), ...layout.chargers.map((charger) => charger.barcode)]);
		const xs = layout.points.map((p) => p.x);
		const ys = layout.points.map((p) => p.y);
		this.box = {
			x0: least(xs, Math.min),
			x1: least(xs, Math.max),
			y0: least(ys, Math.min),
			y1: least(ys, Math.max)
		};
	}
	way(start, end) {
		return this.from.get(start)?.find((way) => way.edge.end === end);
	}
	/** Whether the same piece is driven the other way, too. */
	twoWay(edge) {
		return this.way(edge.end, edge.start) !== void 0;
	}
	/** Place at `mm` of travel along an edge. */
	along(way, mm) {
		const total = way.at.at(-1) ?? 0;
		const want = Math.min(Math.max(mm / way.edge.length, 0), 1) * total;
		let i = 1;
		while (i < way.at.length - 1 && (way.at[i] ?? 0) < want) i++;
		const a = way.pts[i - 1];
		const b = way.pts[i];
		const from = way.at[i - 1] ?? 0;
		const f = (want - from) / ((way.at[i] ?? 0) - from || 1);
		const angle = Math.atan2(b.y - a.y, b.x - a.x);
		return {
			x: a.x + (b.x - a.x) * f,
			y: a.y + (b.y - a.y) * f,
			angle
		};
	}
	/** Place of a barcode, heading as one that has arrived there. */
	spot(barcode) {
		const point = this.points.get(barcode);
		if (!point) return void 0;
		const tangent = this.tangent(barcode, this.before.get(barcode)?.[0] ?? this.next.get(barcode)?.[0]);
		return {
			x: point.x,
			y: point.y,
			angle: Math.atan2(tangent.y, tangent.x)
		};
	}
	/** Barcodes from `start` to `end` by the fewest edges, both included; undefined if more than `limit` edges. */
	path(start, end, limit = 24) {
		if (start === end) return [start];
		const from = /* @__PURE__ */ new Map([[start, ""]]);
		let edge = [start];
		for (let depth = 0; depth < limit && edge.length > 0; depth++) {
			const further = [];
			for (const here of edge) for (const step of this.next.get(here) ?? []) {
				if (from.has(step.end)) continue;
				from.set(step.end, here);
				if (step.end === end) return trace(from, end);
				further.push(step.end);
			}
			edge = further;
		}
	}
	/** All barcodes that hang together with these, whichever way the track is driven. */
	connected(starts) {
		const found = new Set(starts.filter((start) => this.points.has(start)));
		for (const here of found) {
			for (const edge of this.next.get(here) ?? []) found.add(edge.end);
			for (const edge of this.before.get(here) ?? []) found.add(edge.start);
		}
		return found;
	}
	chord(edge) {
		return minus(this.points.get(edge.end), this.points.get(edge.start));
	}
	/** Direction at a barcode for an edge that ends or starts there: that of straight track if there is any, else of the arc. */
	tangent(barcode, own) {
		if (!own) return {
			x: 1,
			y: 0
		};
		const mine = this.chord(own);
		const ins = this.before.get(barcode) ?? [];
		const outs = this.next.get(barcode) ?? [];
		const others = own.end === barcode ? outs : ins;
		const best = (edges) => edges.toSorted((a, b) => dot(unit(this.chord(b)), unit(mine)) - dot(unit(this.chord(a)), unit(mine)))[0];
		const straight = best([...ins, ...outs].filter((edge) => !edge.curve && edge !== own));
		if (!own.curve) return unit(mine);
		if (straight && dot(unit(this.chord(straight)), unit(mine)) > 0) return unit(this.chord(straight));
		const other = best(others);
		if (!other) return unit(mine);
		const theirs = this.chord(other);
		const [l1, l2] = [Math.hypot(mine.x, mine.y) || 1, Math.hypot(theirs.x, theirs.y) || 1];
		return unit({
			x: mine.x / l1 / l1 + theirs.x / l2 / l2,
			y: mine.y / l1 / l1 + theirs.y / l2 / l2
		});
	}
	draw(edge) {
		const a = this.points.get(edge.start);
		const b = this.points.get(edge.end);
		const pts = edge.curve ? arc(a, b, this.tangent(edge.start, edge), this.tangent(edge.end, edge)) : [a, b];
		const at = [0];
		for (let i = 1; i < pts.length; i++) {
			const step = minus(pts[i], pts[i - 1]);
			at.push((at[i - 1] ?? 0) + Math.hypot(step.x, step.y));
		}
		const [xs, ys] = [pts.map((p) => p.x), pts.map((p) => p.y)];
		return {
			edge,
			pts,
			at,
			box: {
				x0: Math.min(...xs),
				x1: Math.max(...xs),
				y0: Math.min(...ys),
				y1: Math.max(...ys)
			}
		};
	}
};
/** A cubic with these directions at its ends, as near to an arc of a circle as a cubic gets. */
function arc(a, b, ta, tb) {
	const chord = Math.hypot(b.x - a.x, b.y - a.y);
	const turn = Math.acos(Math.min(1, Math.max(-1, dot(ta, tb))));
	const reach = turn < .01 ? chord / 3 : chord * (2 / 3) * Math.tan(turn / 4) / Math.sin(turn / 2);
	const c1 = {
		x: a.x + ta.x * reach,
		y: a.y + ta.y * reach
	};
	const c2 = {
		x: b.x - tb.x * reach,
		y: b.y - tb.y * reach
	};
	return Array.from({ length: 9 }, (_, i) => {
		const t = i / STEPS$1;
		const u = 1 - t;
		const [k0, k1, k2, k3] = [
			u * u * u,
			3 * u * u * t,
			3 * u * t * t,
			t * t * t
		];
		return {
			x: k0 * a.x + k1 * c1.x + k2 * c2.x + k3 * b.x,
			y: k0 * a.y + k1 * c1.y + k2 * c2.y + k3 * b.y
		};
	});
}
function keyOf$1(edge) {
	return `${edge.start}>${edge.end}`;
}
function trace(from, end) {
	const path = [end];
	for (let at = from.get(end); at; at = from.get(at)) path.push(at);
	return path.reverse();
}
function push(map, key, value) {
	const list = map.get(key);
	if (list) list.push(value);
	else map.set(key, [value]);
}
function least(values, pick) {
	return values.length ? values.reduce((a, b) => pick(a, b)) : 0;
}
// src/store.ts
/** What the page knows, and how it comes to know it. Objects live in plain maps; a signal per topic says that they changed. */
var EVENTS_SHOWN = 200;
var ENDED_SHOWN = 100;
var TOPICS = "controller,vehicles,jobs,stations,carriers,devices,drives,events";
/** Compares names as people do: V2 before V10. */
var NATURAL = new Intl.Collator(void 0, { numeric: true });
var ENDED = /* @__PURE__ */ new Set([
	"completed",
	"failed",
	"cancelled",
	"aborted"
]);
var layout = y$1(null);
var track = O(() => layout.value ? new Track(layout.value) : null);
var link = y$1("connecting");
var heardAt = y$1(0);
var keyWanted = y$1(false);
var selected = y$1(null);
var notice = y$1("");
/** Rises once a second, for whatever shows an age. */
var tick = y$1(0);
var happenings = y$1([]);
/** Source and destination of the order being written: the map and the panels fill them too. */
var order = {
	source: y$1(""),
	destination: y$1(""),
	carrier: y$1("")
};
var vehicles = /* @__PURE__ */ new Map();
var jobs = /* @__PURE__ */ new Map();
var stations = /* @__PURE__ */ new Map();
var carriers = /* @__PURE__ */ new Map();
var devices = /* @__PURE__ */ new Map();
var drives = /* @__PURE__ */ new Map();
var controllers = /* @__PURE__ */ new Map();
var ended = /* @__PURE__ */ new Map();
var maps = {
	controller: controllers,
	vehicles,
	jobs,
	stations,
	carriers,
	devices,
	drives
};
var changes = {
	controller: y$1(0),
	vehicles: y$1(0),
	jobs: y$1(0),
	stations: y$1(0),
	carriers: y$1(0),
	devices: y$1(0),
	drives: y$1(0)
};
var touched = /* @__PURE__ */ new Set();
var controller = O(() => {
	changes.controller.value;
	return controllers.values().next().value ?? null;
});
/** Rises when a vehicle comes or goes: they are sorted then only. */
var members = y$1(0);
var vehicleOrder = O(() => {
	members.value;
	return [...vehicles.keys()].sort((a, b) => NATURAL.compare(a, b));
});
var vehicleList = O(() => {
	changes.vehicles.value;
	return vehicleOrder.value.flatMap((id) => vehicles.get(id) ?? []);
});
/** Doors, buffers and chargers in the order of the plant file. */
var machines = O(() => {
	const { doors = [], buffers = [], chargers: places = [] } = layout.value ?? {};
	const of = (list, kind) => list.map(({ id }) => ({
		id,
		kind
	}));
	return [
		...of(doors, "door"),
		...of(buffers, "buffer"),
		...of(places, "charger")
	];
});
/** What is wrong now. */
var troubles = O(() => {
	changes.vehicles.value;
	changes.devices.value;
	changes.drives.value;
	return wrongs({
		controller: controller.value,
		vehicles: vehicles.values(),
		devices: devices.values(),
		drives: drives.values()
	});
});
var driveList = O(() => {
	changes.drives.value;
	return [...drives.values()].sort(byId);
});
function byId(a, b) {
	return NATURAL.compare(a.id, b.id);
}
/** Open and ended jobs, newest first. */
var jobList = O(() => {
	changes.jobs.value;
	return [...jobs.values(), ...[...ended.values()].filter((job) => !jobs.has(job.id))].sort((a, b) => b.order - a.order);
});
function vehicleNow(id) {
	changes.vehicles.value;
	return vehicles.get(id);
}
function stationNow(id) {
	changes.stations.value;
	return stations.get(id);
}
function deviceNow(id) {
	changes.devices.value;
	return devices.get(id);
}
/** Choose a door, buffer or charger; a buffer is shown with the station that it belongs to. */
function chooseDevice(id) {
	const station = layout.value?.stations.find((one) => one.buffer === id);
	selected.value = station ? {
		kind: "station",
		id: station.id
	} : {
		kind: "device",
		id
	};
}
function driveNow(id) {
	changes.drives.value;
	return drives.get(id);
}
/** AGVs that charge at a charger: those on their way there are named by the server, too. */
function chargingAt(id) {
	const tag = layout.value?.chargers.find((charger) => charger.id === id)?.barcode;
	return [...vehicles.values()].filter((one) => one.activity === "charging" && one.barcode === tag).map((one) => one.id);
}
/** How a door, buffer or charger looks. */
function lookAt(id) {
	const device = devices.get(id);
	if (!layout.value?.chargers.some((charger) => charger.id === id)) return lookOfDevice(device);
	const taken = chargingAt(id).length > 0;
	return device ? lookOfDevice(device, taken) : taken ? "charging" : "free";
}
/** Who is in a door or will pass it, or charges at a charger. */
function passers(id) {
	return [.../* @__PURE__ */ new Set([...devices.get(id)?.vehicles ?? [], ...chargingAt(id)])];
}
/** Who is at which machine, as one text: it changes far less often than the vehicles do. */
var presence = O(() => {
	changes.devices.value;
	changes.vehicles.value;
	return machines.value.map(({ id }) => `${id} ${passers(id).join()}`).join();
});
/** Choose an end of the order; an end at the other side that no vehicle could join to it is forgotten. */
function orderFrom(id) {
	order.source.value = id;
	if (!joins(layout.value, id, order.destination.value)) order.destination.value = "";
}
function orderTo(id) {
	order.destination.value = id;
	if (!joins(layout.value, order.source.value, id)) order.source.value = "";
}
function isTopic(name) {
	return name in maps;
}
/** One round for all that changed: what shows several topics is drawn once. */
function flush() {
	r(() => {
		heardAt.value = Date.now();
		for (const topic of touched) changes[topic].value++;
		touched.clear();
	});
}
var sink = {
	snapshot(objects, lastEvent) {
		for (const topic of Object.keys(maps)) {
			const map = maps[topic];
			map.clear();
			for (const [key, value] of Object.entries(objects[topic] ?? {})) map.set(key, value);
			touched.add(topic);
		}
		members.value++;
		flush();
		refreshEnded();
		if (happenings.value.length === 0) earlier(lastEvent);
	},
	change(topic, key, value) {
		if (!isTopic(topic)) return;
		const map = maps[topic];
		if (topic === "vehicles" && (value === null || !map.has(key))) members.value++;
		if (value !== null) map.set(key, value);
		else {
			map.delete(key);
			if (topic === "jobs") refreshSoon();
		}
		touched.add(topic);
	},
	changed: flush,
	events: remember,
	forget() {
		happenings.value = [];
	},
	problem(text) {
		notice.value = text;
	}
};
function remember(events) {
	const known = new Set(happenings.value.map((event) => event.seq));
	happenings.value = [...happenings.value, ...events.filter((event) => !known.has(event.seq))].sort((a, b) => b.seq - a.seq).slice(0, EVENTS_SHOWN);
}
async function earlier(last) {
	if (last < 1) return;
	try {
		remember((await get(`/events?after=${Math.max(0, last - 60)}&limit=60`)).items);
	} catch {}
}
var refreshing = 0;
/** Jobs leave the live model when they end: the list asks for how they ended. */
function refreshSoon() {
	window.clearTimeout(refreshing);
	refreshing = window.setTimeout(() => void refreshEnded(), 250);
}
async function refreshEnded() {
	try {
		const { items } = await get(`/jobs?limit=${ENDED_SHOWN}`);
		ended.clear();
		for (const job of items) if (ENDED.has(job.state)) ended.set(job.id, job);
		changes.jobs.value++;
	} catch {}
}
var stream = new Stream(sink);
var watcher = null;
async function address(after) {
	const query = new URLSearchParams({ topics: TOPICS });
	if (after !== null) query.set("after", String(after));
	if (hasKey()) try {
		query.set("ticket", (await post("/live/ticket")).ticket);
	} catch (error) {
		if (error instanceof Refused && error.status === 401) return null;
		throw error;
	}
	return `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/api/v1/live?${query}`;
}
/** Read the layout, then watch; waits for a key if the server wants one, and for the server if it is not there. */
async function start() {
	try {
		layout.value = await get("/layout");
	} catch (error) {
		link.value = "lost";
		if (!(error instanceof Refused && error.status === 401)) window.setTimeout(() => void start(), 2e3);
		return;
	}
	watcher ??= new Watcher(stream, {
		address,
		alive,
		state: (now) => link.value = now
	});
	watcher.open();
}
function begin$2() {
	onKeyWanted(() => keyWanted.value = true);
	window.setInterval(() => tick.value++, 1e3);
	start();
}
// src/route.ts
/** Which room of the page is open and what is chosen in it, kept in the address: it can be sent to somebody. */
var ROOMS = [
	"map",
	"vehicles",
	"jobs",
	"alarms"
];
var KINDS = /* @__PURE__ */ new Set([
	"vehicle",
	"station",
	"device",
	"drive",
	"job"
]);
var room$1 = y$1("map");
function isRoom(name) {
	return ROOMS.includes(name);
}
function read() {
	const [path = "", query = ""] = location.hash.replace(/^#\/?/, "").split("?");
	room$1.value = isRoom(path) ? path : "map";
	const [[kind, id] = []] = [...new URLSearchParams(query)];
	if (kind && id && KINDS.has(kind)) selected.value = {
		kind,
		id
	};
}
/** Follow the address, and keep it up to date. */
function begin$1() {
	read();
	window.addEventListener("hashchange", read);
	x(() => {
		const pick = selected.value;
		const query = pick ? `?${new URLSearchParams({ [pick.kind]: pick.id })}` : "";
		const next = `#/${room$1.value}${query}`;
		if (location.hash !== next) history.replaceState(null, "", next);
	});
}
// ../app/texts/en.json
var page$1 = {
	"live": "Live",
	"connecting": "Connecting",
	"lost": "Reconnecting",
	"lost_age": "Reconnecting · data {0} s old",
	"lost_none": "The server does not answer; trying again",
	"controller": "Controller",
	"auto": "Auto",
	"pausing": "Pausing",
	"waiting_for": "Roll-call: waiting for {0}",
	"vehicles": "Vehicles",
	"choose_vehicle": "Choose a vehicle…",
	"jobs": "Jobs",
	"open_jobs": "Open jobs",
	"open": "Open",
	"ended": "Ended",
	"all": "All",
	"no_jobs": "No jobs here. Post one above.",
	"events": "Events",
	"no_events": "Nothing has happened yet.",
	"new_transfer": "New transfer",
	"source": "From",
	"destination": "To",
	"carrier": "Carrier",
	"carrier_optional": "as it stands there",
	"priority": "Priority",
	"order": "Order",
	"ordering": "Ordering…",
	"ordered": "Job {0} accepted",
	"choose": "Choose…",
	"ports": "Ports",
	"buffers": "Side buffers",
	"agv_buffers": "AGV buffers",
	"loaded_vehicles": "Vehicles with a carrier",
	"cancel": "Cancel",
	"abort": "Abort",
	"sure": "Sure?",
	"close": "Close",
	"fit": "Fit",
	"zoom_in": "Zoom in",
	"zoom_out": "Zoom out",
	"map": "Map",
	"state": "State",
	"activity": "Activity",
	"mode": "Mode",
	"oper": "Operation",
	"place": "Place",
	"job": "Job",
	"goal": "Goal",
	"link": "Link",
	"link_up": "up since {0}",
	"link_down": "down since {0}",
	"round_trip": "Round trip",
	"frames_io": "Frames in / out",
	"trouble_counts": "Garbled / resent / repeated",
	"seen": "Last status",
	"ago": "{0} ago",
	"dialect": "Dialect",
	"address": "Address",
	"none": "none",
	"empty": "empty",
	"loaded": "loaded",
	"unknown": "not known",
	"waits": "Waits",
	"held_note": "Held",
	"held": "held",
	"locked": "Locked out by {0}",
	"hold": "Hold",
	"release": "Release",
	"reason": "Reason",
	"verdict": "What you found",
	"verdict_go_on": "What it reports is true: go on",
	"verdict_off_rail": "It is off the rail",
	"verdict_stands_at": "It stands at a barcode",
	"barcode": "Barcode",
	"your_name": "Your name",
	"name_hint": "Kept with everything that you ask for",
	"status_bits": "Status bits",
	"status": "Status",
	"tag": "Tag",
	"last_tag": "Last tag read",
	"beyond": "Stopped on its way to",
	"charges_now": "Charging",
	"cart": "Cart",
	"lift": "Lift",
	"steering": "Direction",
	"in_position": "In position",
	"path": "Moves taken",
	"agv_none": "none",
	"agv_present": "present",
	"agv_unknown": "not known",
	"agv_up": "up",
	"agv_down": "down",
	"agv_straight": "straight on",
	"agv_left": "left",
	"agv_right": "right",
	"agv_mark_stop": "stops at a mark",
	"no_status": "No status yet",
	"last_frames": "Last frames",
	"no_frames": "No traffic yet",
	"kind": "Kind",
	"port": "Port",
	"sbfl": "Side buffer, left",
	"sbfr": "Side buffer, right",
	"agv_buffer": "AGV buffer",
	"present": "Occupied",
	"yes": "yes",
	"no": "no",
	"believed": "believed",
	"verified": "verified",
	"provenance": "Known from",
	"host": "the host",
	"placed": "a vehicle put it there",
	"picked": "a vehicle took it",
	"person": "a person",
	"inferred": "inferred",
	"sensor": "its sensor",
	"plant": "the plant file",
	"reserved": "Reserved",
	"out_of_service": "Out of service",
	"target": "Target pulses",
	"use_source": "Order from here",
	"use_destination": "Order to here",
	"key_title": "This server wants an access key",
	"key_label": "Access key",
	"key_hint": "Kept in this tab only, until you close it.",
	"key_use": "Use key",
	"legend_carrier": "carrier",
	"legend_zone": "no-stop zone",
	"legend_door": "door closed, open",
	"look_idle": "idle",
	"look_moving": "moving",
	"look_waiting": "waiting",
	"look_handling": "pick / place",
	"look_charging": "charging",
	"look_held": "held",
	"look_alarm": "alarm",
	"look_gone": "absent",
	"idle": "idle",
	"moving": "moving",
	"waiting": "waiting",
	"busy": "busy",
	"settling": "settling",
	"absent": "absent",
	"off_rail": "off the rail",
	"locked_out": "locked out",
	"recovering": "recovering",
	"alarm": "alarm",
	"charging": "charging",
	"acquiring": "picking up",
	"depositing": "putting down",
	"paused": "paused",
	"removed": "removed",
	"not_assigned": "not assigned",
	"enroute": "en route",
	"parked": "parked",
	"queued": "queued",
	"transferring": "transferring",
	"cancelling": "cancelling",
	"aborting": "aborting",
	"completed": "completed",
	"failed": "failed",
	"cancelled": "cancelled",
	"aborted": "aborted",
	"in_service": "in service",
	"devices": "Devices",
	"door": "Door",
	"buffer": "Buffer",
	"charger": "Charger",
	"device_open": "open",
	"device_closed": "closed",
	"device_cart": "cart there",
	"device_no_cart": "no cart",
	"device_charging": "charging",
	"device_free": "free",
	"device_busy": "busy",
	"device_unknown": "not known",
	"device_error": "error",
	"device_silent": "not heard",
	"since": "since {0}",
	"last_word": "last said: {0}",
	"passing": "Passing",
	"charges": "Charging",
	"nobody": "nobody",
	"wait_for_it": "Waiting",
	"lock_for": "Locked for",
	"lock_unsure": "not confirmed",
	"not_locked": "nobody",
	"pinned": "Kept {0} by {1}",
	"pending": "Under way",
	"contradicts": "Differs from the books",
	"at_station": "Station",
	"on_line": "Line",
	"line_number": "{0} · number {1}",
	"cmd_open": "Open door",
	"cmd_close": "Close door",
	"cmd_lock": "Lock",
	"cmd_unlock": "Unlock",
	"asked": "Asked for: {0}",
	"drives": "Drives",
	"drive": "Drive",
	"drive_parameter_select": "parameter select",
	"drive_parameter_value": "parameter setting",
	"drive_monitoring": "monitoring",
	"drive_jog": "jog",
	"drive_error": "error",
	"drive_offline": "offline",
	"drive_not_heard": "not heard yet",
	"drive_online": "online",
	"error_fact": "Error",
	"operation_fact": "Operates",
	"output": "Output",
	"turn": "Turns",
	"cw": "clockwise",
	"ccw": "counter-clockwise",
	"distance": "Distance",
	"model": "Model",
	"moves": "Moves",
	"stop_reset": "Stop / reset",
	"parameters": "Parameters",
	"read_parameters": "Read parameters",
	"reading": "Read {0} of {1}",
	"no_parameters": "None read yet",
	"op_done": "{0}: done",
	"op_running": "{0}: asked for",
	"op_unknown": "It is not known whether it took effect",
	"no_model": "none: parameters by number",
	"map_label": "Map of the track. Drag to move, wheel to zoom, click what you want to know about.",
	"vehicle": "Vehicle",
	"alarms": "Alarms",
	"no_alarms": "Nothing is wrong.",
	"rooms": "Rooms",
	"find": "Find",
	"nothing_found": "Nothing of that name",
	"filter": "Filter",
	"more_rows": "{0} more",
	"show_more": "Show more",
	"layers": "Layers",
	"layer_grants": "Granted track",
	"layer_zones": "Zones",
	"layer_closures": "Closures",
	"layer_holds": "Holds and lockouts",
	"heat": "Heat since this page was opened",
	"heat_off": "none",
	"heat_waiting": "Waiting",
	"heat_traffic": "Traffic",
	"little": "little",
	"much": "much",
	"follow": "Follow",
	"follow_hint": "Keep the chosen vehicle in the middle (F)",
	"keys": "Keys of the map",
	"key_find": "find something",
	"key_pan": "move the map",
	"key_zoom": "zoom",
	"key_fit": "show everything",
	"key_follow": "follow the chosen vehicle",
	"key_none": "choose nothing",
	"legend_soft": "soft zone",
	"theme_light": "Light colours",
	"theme_dark": "Dark colours",
	"idle_parked": "idle, parked",
	"why": "Why",
	"circle": "Circle of hoists",
	"circles_counted": "found {0}, over {1} since the start",
	"job_details": "All about this job",
	"fallbacks": "else {0}",
	"wished": "wished: {0}",
	"ordered_by": "Ordered by",
	"ordered_at": "Ordered",
	"result": "Result",
	"phases": "How long each phase took",
	"phase_queued": "queued",
	"phase_fetching": "fetching",
	"phase_carrying": "carrying",
	"why_vehicle": "Why this vehicle",
	"not_assigned_yet": "It has no vehicle yet.",
	"why_waits": "What it waited for",
	"never_waited": "It did not have to wait.",
	"still": "still",
	"left_out": "{0} between the first and the latest are left out",
	"to_source": "{0} to the source",
	"hot_lot": "hot lot",
	"instead_of": "instead of {0}: {1} nearer",
	"worth": "waiting counted for {0}, a change had to save {1}",
	"no_way": "no way",
	"change": "Change",
	"any": "any",
	"taken": "Done",
	"older": "Older ones",
	"takes": "Takes",
	"device": "Device"
};
var sayings$2 = {};
// ../app/texts/ko.json
var page = {
	"live": "실시간",
	"connecting": "연결 중",
	"lost": "재연결 중",
	"lost_age": "재연결 중 · {0}초 전 데이터",
	"lost_none": "서버가 응답하지 않습니다. 다시 시도합니다",
	"controller": "제어기",
	"auto": "자동",
	"pausing": "일시정지 중",
	"waiting_for": "점호: {0} 대기",
	"vehicles": "차량",
	"choose_vehicle": "차량 선택…",
	"jobs": "작업",
	"open_jobs": "진행 작업",
	"open": "진행",
	"ended": "종료",
	"all": "전체",
	"no_jobs": "작업이 없습니다. 위에서 등록하세요.",
	"events": "이벤트",
	"no_events": "아직 이벤트가 없습니다.",
	"new_transfer": "새 반송",
	"source": "출발",
	"destination": "도착",
	"carrier": "캐리어",
	"carrier_optional": "현재 캐리어",
	"priority": "우선순위",
	"order": "등록",
	"ordering": "등록 중…",
	"ordered": "작업 {0} 접수됨",
	"choose": "선택…",
	"ports": "포트",
	"buffers": "사이드 버퍼",
	"agv_buffers": "AGV 버퍼",
	"loaded_vehicles": "적재 차량",
	"cancel": "취소",
	"abort": "중단",
	"sure": "확인?",
	"close": "닫기",
	"fit": "전체 보기",
	"zoom_in": "확대",
	"zoom_out": "축소",
	"map": "지도",
	"state": "상태",
	"activity": "동작",
	"mode": "모드",
	"oper": "운전",
	"place": "위치",
	"job": "작업",
	"goal": "목표",
	"link": "링크",
	"link_up": "{0}부터 연결",
	"link_down": "{0}부터 끊김",
	"round_trip": "왕복 시간",
	"frames_io": "프레임 수신 / 송신",
	"trouble_counts": "손상 / 재전송 / 중복",
	"seen": "최근 상태 보고",
	"ago": "{0} 전",
	"dialect": "프로토콜 변형",
	"address": "주소",
	"none": "없음",
	"empty": "비어 있음",
	"loaded": "적재",
	"unknown": "모름",
	"waits": "대기",
	"held_note": "보류",
	"held": "보류",
	"locked": "{0} 정비 잠금",
	"hold": "보류",
	"release": "해제",
	"reason": "사유",
	"verdict": "확인 결과",
	"verdict_go_on": "보고가 맞음: 계속",
	"verdict_off_rail": "레일에서 제거됨",
	"verdict_stands_at": "바코드 위치에 서 있음",
	"barcode": "바코드",
	"your_name": "이름",
	"name_hint": "모든 요청에 기록됩니다",
	"status_bits": "상태 비트",
	"status": "상태 보고 내용",
	"tag": "태그",
	"last_tag": "마지막 태그",
	"beyond": "정지 전 이동 목표",
	"charges_now": "충전 중",
	"cart": "카트",
	"lift": "리프트",
	"steering": "방향",
	"in_position": "정위치",
	"path": "수락한 이동",
	"agv_none": "없음",
	"agv_present": "있음",
	"agv_unknown": "모름",
	"agv_up": "상승",
	"agv_down": "하강",
	"agv_straight": "직진",
	"agv_left": "좌",
	"agv_right": "우",
	"agv_mark_stop": "마크 정지",
	"no_status": "상태 보고 없음",
	"last_frames": "최근 프레임",
	"no_frames": "통신 없음",
	"kind": "종류",
	"port": "포트",
	"sbfl": "좌측 사이드 버퍼",
	"sbfr": "우측 사이드 버퍼",
	"agv_buffer": "AGV 버퍼",
	"present": "점유",
	"yes": "예",
	"no": "아니오",
	"believed": "추정",
	"verified": "확인됨",
	"provenance": "근거",
	"host": "호스트",
	"placed": "차량이 내려놓음",
	"picked": "차량이 가져감",
	"person": "작업자",
	"inferred": "추론",
	"sensor": "센서",
	"plant": "플랜트 파일",
	"reserved": "예약",
	"out_of_service": "사용 중지",
	"target": "목표 펄스",
	"use_source": "여기서 출발",
	"use_destination": "여기로 도착",
	"key_title": "접근 키가 필요합니다",
	"key_label": "접근 키",
	"key_hint": "이 탭에만 저장되며 닫으면 지워집니다.",
	"key_use": "사용",
	"legend_carrier": "캐리어",
	"legend_zone": "정지 금지 구역",
	"legend_door": "도어 닫힘, 열림",
	"look_idle": "유휴",
	"look_moving": "이동",
	"look_waiting": "대기",
	"look_handling": "이적재",
	"look_charging": "충전",
	"look_held": "보류",
	"look_alarm": "알람",
	"look_gone": "부재",
	"idle": "유휴",
	"moving": "이동 중",
	"waiting": "대기",
	"busy": "작업 중",
	"settling": "확인 중",
	"absent": "응답 없음",
	"off_rail": "레일 밖",
	"locked_out": "정비 잠금",
	"recovering": "복구 중",
	"alarm": "알람",
	"charging": "충전 중",
	"acquiring": "적재 중",
	"depositing": "이재 중",
	"paused": "일시정지",
	"removed": "제거됨",
	"not_assigned": "미할당",
	"enroute": "이동 중",
	"parked": "정차",
	"queued": "대기열",
	"transferring": "반송 중",
	"cancelling": "취소 중",
	"aborting": "중단 중",
	"completed": "완료",
	"failed": "실패",
	"cancelled": "취소됨",
	"aborted": "중단됨",
	"in_service": "사용 중",
	"devices": "장치",
	"door": "도어",
	"buffer": "버퍼",
	"charger": "충전기",
	"device_open": "열림",
	"device_closed": "닫힘",
	"device_cart": "카트 있음",
	"device_no_cart": "카트 없음",
	"device_charging": "충전 중",
	"device_free": "비어 있음",
	"device_busy": "동작 중",
	"device_unknown": "상태 모름",
	"device_error": "오류",
	"device_silent": "응답 없음",
	"since": "{0}부터",
	"last_word": "마지막 상태: {0}",
	"passing": "통과 차량",
	"charges": "충전 차량",
	"nobody": "없음",
	"wait_for_it": "대기 차량",
	"lock_for": "잠금 요청자",
	"lock_unsure": "확인되지 않음",
	"not_locked": "잠금 없음",
	"pinned": "{1} 님이 {0} 상태로 유지",
	"pending": "진행 중 명령",
	"contradicts": "기록과 다름",
	"at_station": "스테이션",
	"on_line": "라인",
	"line_number": "{0} · 번호 {1}",
	"cmd_open": "도어 열기",
	"cmd_close": "도어 닫기",
	"cmd_lock": "잠금",
	"cmd_unlock": "잠금 해제",
	"asked": "요청됨: {0}",
	"drives": "드라이브",
	"drive": "드라이브",
	"drive_parameter_select": "파라미터 선택",
	"drive_parameter_value": "파라미터 설정",
	"drive_monitoring": "모니터링",
	"drive_jog": "조그",
	"drive_error": "오류",
	"drive_offline": "오프라인",
	"drive_not_heard": "아직 응답 없음",
	"drive_online": "온라인",
	"error_fact": "오류",
	"operation_fact": "운전 방식",
	"output": "출력",
	"turn": "회전 방향",
	"cw": "시계 방향",
	"ccw": "반시계 방향",
	"distance": "이동 거리",
	"model": "모델",
	"moves": "움직임",
	"stop_reset": "정지 / 리셋",
	"parameters": "파라미터",
	"read_parameters": "파라미터 읽기",
	"reading": "{1}개 중 {0}개 읽음",
	"no_parameters": "아직 읽지 않음",
	"op_done": "{0}: 완료",
	"op_running": "{0}: 요청됨",
	"op_unknown": "적용 여부를 알 수 없음",
	"no_model": "없음: 번호로만 파라미터 접근",
	"map_label": "트랙 지도. 드래그로 이동, 휠로 확대, 알고 싶은 것을 클릭하세요.",
	"vehicle": "차량",
	"alarms": "알람",
	"no_alarms": "이상이 없습니다.",
	"rooms": "화면",
	"find": "찾기",
	"nothing_found": "일치하는 항목 없음",
	"filter": "필터",
	"more_rows": "{0}개 더 있음",
	"show_more": "더 보기",
	"layers": "레이어",
	"layer_grants": "허가된 경로",
	"layer_zones": "구역",
	"layer_closures": "폐쇄",
	"layer_holds": "보류·정비 잠금",
	"heat": "페이지를 연 이후 히트맵",
	"heat_off": "없음",
	"heat_waiting": "대기 시간",
	"heat_traffic": "통행량",
	"little": "적음",
	"much": "많음",
	"follow": "따라가기",
	"follow_hint": "선택한 차량을 가운데에 유지 (F)",
	"keys": "지도 단축키",
	"key_find": "찾기",
	"key_pan": "지도 이동",
	"key_zoom": "확대·축소",
	"key_fit": "전체 보기",
	"key_follow": "선택한 차량 따라가기",
	"key_none": "선택 해제",
	"legend_soft": "완화 구역",
	"theme_light": "밝은 화면",
	"theme_dark": "어두운 화면",
	"idle_parked": "유휴, 주차",
	"why": "사유",
	"circle": "호이스트 순환 대기",
	"circles_counted": "시작 이후 발견 {0}, 해소 {1}",
	"job_details": "작업 상세",
	"fallbacks": "대체 {0}",
	"wished": "지정 차량: {0}",
	"ordered_by": "등록자",
	"ordered_at": "등록 시각",
	"result": "결과",
	"phases": "단계별 소요 시간",
	"phase_queued": "대기",
	"phase_fetching": "인수 이동",
	"phase_carrying": "운반",
	"why_vehicle": "왜 이 차량인가",
	"not_assigned_yet": "아직 배정된 차량이 없습니다.",
	"why_waits": "무엇을 기다렸나",
	"never_waited": "기다리지 않았습니다.",
	"still": "계속",
	"left_out": "처음과 최근 사이 {0}건 생략",
	"to_source": "출발지까지 {0}",
	"hot_lot": "긴급 로트",
	"instead_of": "{0} 대신: {1} 가까움",
	"worth": "대기 가산 {0}, 변경 최소 이득 {1}",
	"no_way": "경로 없음",
	"change": "변경",
	"any": "아무 차량",
	"taken": "완료",
	"older": "이전 작업",
	"takes": "소요",
	"device": "장치"
};
var sayings$1 = {};
// src/sayings.ts
/** Sentences within sentences are translated too, so deep. */
var DEPTH = 4;
var KEPT$3 = 2e3;
var Sayings = class {
	list;
	known = /* @__PURE__ */ new Map();
	/** Two catalogues of the same keys; {0}, {1} … are slots. */
	constructor(from, to) {
		this.list = Object.entries(from).map(([key, text]) => ({
			pattern: patternOf(text),
			other: to[key] ?? text,
			weight: text.replace(/\{\d\}/g, "").length
		}));
		this.list.sort((a, b) => b.weight - a.weight);
	}
	translate(sentence) {
		if (!sentence) return sentence;
		const known = this.known.get(sentence);
		if (known !== void 0) return known;
		const found = this.retold(sentence, DEPTH);
		if (this.known.size >= KEPT$3) this.known.clear();
		this.known.set(sentence, found);
		return found;
	}
	retold(sentence, depth) {
		for (const { pattern, other } of this.list) {
			const match = pattern.exec(sentence);
			if (!match) continue;
			return other.replace(/\{(\d)\}/g, (_, slot) => {
				const part = match.groups?.[`s${slot}`] ?? "";
				return depth > 0 && part.includes(" ") ? this.retold(part, depth - 1) : part;
			});
		}
		return sentence;
	}
};
function patternOf(text) {
	const parts = text.split(/(\{\d\})/).map((part) => {
		const slot = /^\{(\d)\}$/.exec(part);
		return slot ? `(?<s${slot[1]}>.+?)` : part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
	});
	return new RegExp(`^${parts.join("")}$`, "s");
}
// src/texts.ts
/**
* Every word of the page, in both languages, from the catalogue that the API and the command line speak from as well
* (app/texts). What the server says in sentences is translated by the catalogue's sayings where it has them.
*/
var KEPT$2 = "hoistway.language";
var kept$2 = localStorage.getItem(KEPT$2);
var language = y$1(kept$2 === "en" || kept$2 === "ko" ? kept$2 : navigator.language.startsWith("ko") ? "ko" : "en");
var sayings = new Sayings(sayings$2, sayings$1);
function speak(next) {
	localStorage.setItem(KEPT$2, next);
	language.value = next;
	document.documentElement.lang = next;
}
/** A word or sentence; {0}, {1} … are replaced. */
function t(word, ...values) {
	const text = (language.value === "ko" ? page : page$1)[word];
	return values.reduce((sentence, value, i) => sentence.replace(`{${i}}`, String(value)), text);
}
/** The server's word for a state, translated if we know it. */
function said(word) {
	return Object.hasOwn(page$1, word) ? t(word) : word.replaceAll("_", " ");
}
/** A sentence of the server, translated as far as the catalogue knows it. */
function tell(sentence) {
	return language.value === "ko" ? sayings.translate(sentence) : sentence;
}
// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var f = Symbol.for("pv");
var o = 0;
Array.isArray;
function a(t, e, n, u, a, i) {
	e || (e = {});
	var c, l, p = e;
	if ("ref" in p && "function" != typeof t) for (l in p = {}, e) "ref" == l ? c = e[l] : p[l] = e[l];
	var s = {
		type: t,
		props: p,
		key: n,
		ref: c,
		__k: null,
		__: null,
		__b: 0,
		__e: null,
		__c: null,
		constructor: f,
		__v: --o,
		__i: -1,
		__u: 0
	};
	return (a || i) && (s.__source = a, s.__self = i), n$1.vnode && n$1.vnode(s), s;
}
// src/parts/Alarms.tsx
/** What is wrong now: cause, and what helps. */
function Alarms() {
	const list = troubles.value;
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("alarms"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: /* @__PURE__ */ a("h2", { children: [
				t("alarms"),
				" ",
				list.length
			] })
		}), /* @__PURE__ */ a("ul", {
			class: "scroll alarms",
			tabIndex: 0,
			"aria-label": t("alarms"),
			children: [list.length === 0 && /* @__PURE__ */ a("li", {
				class: "nothing",
				children: t("no_alarms")
			}), list.map((wrong) => /* @__PURE__ */ a(Line$1, { wrong }, wrong.key))]
		})]
	});
}
function Line$1({ wrong }) {
	const { kind, source } = wrong;
	return /* @__PURE__ */ a("li", {
		"data-alarm": wrong.key,
		children: [
			/* @__PURE__ */ a("span", {
				class: `sign ${wrong.grave ? "" : "wait"}`,
				title: t(wrong.grave ? "alarm" : "held"),
				children: wrong.grave ? "!" : "‖"
			}),
			/* @__PURE__ */ a("span", { children: [
				kind === "controller" ? /* @__PURE__ */ a("b", { children: t("controller") }) : /* @__PURE__ */ a("button", {
					type: "button",
					class: "text",
					onClick: () => selected.value = {
						kind,
						id: source
					},
					children: /* @__PURE__ */ a("b", { children: source })
				}),
				" ",
				tell(wrong.cause),
				" ",
				wrong.since && /* @__PURE__ */ a("small", {
					class: "calm",
					children: ["· ", clock(wrong.since)]
				})
			] }),
			wrong.remedy && /* @__PURE__ */ a("p", {
				class: "remedy",
				children: tell(wrong.remedy)
			})
		]
	});
}
// src/parts/DeviceList.tsx
/** Doors, buffers and chargers, each in one line. */
function DeviceList() {
	return /* @__PURE__ */ a("ul", {
		class: "scroll machines",
		children: machines.value.map(({ id, kind }) => /* @__PURE__ */ a(Row$2, {
			id,
			kind
		}, id))
	});
}
/** What people have decided about a device: it does not do what its state alone would let one expect. */
function barred({ lockout, out_of_service, pin }) {
	if (lockout) return `${t("locked", lockout.owner)} ${lockout.reason}`;
	if (out_of_service) return `${t("out_of_service")}: ${out_of_service}`;
	return pin ? `${t("pinned", t(pin.position === "open" ? "device_open" : "device_closed"), pin.owner)}: ${pin.reason}` : "";
}
function Row$2({ id, kind }) {
	const device = deviceNow(id);
	presence.value;
	const look = lookAt(id);
	const station = layout.value?.stations.find((one) => one.buffer === id)?.id;
	const barcode = layout.value?.chargers.find((one) => one.id === id)?.barcode;
	const who = kind === "buffer" ? device?.lock?.owner ?? "" : passers(id).join(", ");
	const why = tell(device?.alarm || device?.contradiction || device && barred(device) || device?.reason || "");
	return /* @__PURE__ */ a("li", { children: /* @__PURE__ */ a("button", {
		type: "button",
		class: "row",
		"aria-pressed": selected.value?.id === id || station !== void 0 && selected.value?.id === station,
		"data-device": id,
		onClick: () => chooseDevice(id),
		children: [
			/* @__PURE__ */ a("i", {
				class: "dot",
				style: { background: colourOfDevice(device, look) }
			}),
			/* @__PURE__ */ a("b", { children: id }),
			/* @__PURE__ */ a("span", { children: t(kind) }),
			/* @__PURE__ */ a("span", {
				style: { color: DEVICE_LOOKS[look] },
				children: t(`device_${look}`)
			}),
			/* @__PURE__ */ a("span", { children: station ?? barcode ?? "" }),
			/* @__PURE__ */ a("span", { children: who }),
			/* @__PURE__ */ a("span", {
				class: device?.alarm ? "more bad" : "more",
				title: why,
				children: why
			})
		]
	}) });
}
// src/parts/DriveList.tsx
/** Axis drives, each in one line: what it does, or what is wrong with it. */
function DriveList() {
	return /* @__PURE__ */ a("ul", {
		class: "scroll machines",
		children: driveList.value.map((drive) => /* @__PURE__ */ a(Row$1, { drive }, drive.id))
	});
}
function Row$1({ drive }) {
	const { word, tone } = lookOfDrive(drive);
	const chosen = selected.value?.kind === "drive" && selected.value.id === drive.id;
	const heard = drive.online === true;
	const why = drive.online ? drive.meaning : drive.reason;
	const choose = () => {
		selected.value = chosen ? null : {
			kind: "drive",
			id: drive.id
		};
	};
	return /* @__PURE__ */ a("li", { children: /* @__PURE__ */ a("button", {
		type: "button",
		class: "row drives",
		"aria-pressed": chosen,
		"data-drive": drive.id,
		onClick: choose,
		children: [
			/* @__PURE__ */ a("i", { class: `dot ${tone}` }),
			/* @__PURE__ */ a("b", { children: drive.id }),
			/* @__PURE__ */ a("span", {
				title: drive.name,
				children: drive.name
			}),
			/* @__PURE__ */ a("span", {
				class: tone,
				children: t(`drive_${word}`)
			}),
			/* @__PURE__ */ a("span", {
				class: "number",
				children: heard && drive.distance !== null ? hundredths(drive.distance) : ""
			}),
			/* @__PURE__ */ a("span", {
				class: tone === "bad" ? "more bad" : "more",
				title: why,
				children: why
			})
		]
	}) });
}
// src/parts/Events.tsx
/** What has happened, newest first. */
var BAD = /AlarmSet|Failed|VehicleHeld|VehicleRemoved|Abort/;
var GOOD = /TransferCompleted|AlarmCleared|VehicleReleased/;
var SHOWN$2 = 80;
function Events() {
	const list = happenings.value;
	return /* @__PURE__ */ a("ol", {
		class: "scroll events",
		reversed: true,
		children: [list.length === 0 && /* @__PURE__ */ a("li", {
			class: "nothing",
			children: t("no_events")
		}), list.slice(0, SHOWN$2).map((event) => /* @__PURE__ */ a(Line, { event }, event.seq))]
	});
}
function Line({ event }) {
	const tone = BAD.test(event.event) ? "bad" : GOOD.test(event.event) ? "good" : "";
	const where = [event.source, event.destination].filter(Boolean).join(" → ");
	return /* @__PURE__ */ a("li", {
		"data-event": event.seq,
		children: [
			/* @__PURE__ */ a("time", { children: clock(event.ts) }),
			/* @__PURE__ */ a("span", {
				class: "seq",
				children: ["#", event.seq]
			}),
			/* @__PURE__ */ a("b", {
				class: tone,
				children: sentence(event.event)
			}),
			event.vehicle ? /* @__PURE__ */ a("button", {
				type: "button",
				class: "text",
				onClick: () => selected.value = {
					kind: "vehicle",
					id: event.vehicle
				},
				children: event.vehicle
			}) : /* @__PURE__ */ a("span", {}),
			/* @__PURE__ */ a("span", {
				class: "more",
				children: [.../* @__PURE__ */ new Set([
					event.job,
					event.carrier,
					where,
					event.result,
					tell(event.detail)
				])].filter(Boolean).join(" · ")
			})
		]
	});
}
// src/parts/Below.tsx
/** Below the map: what has happened, and the plant's other machines, each a list to look through and to choose from. */
function Below() {
	const tab = useSignal("events");
	changes.devices.value;
	const counts = {
		events: 0,
		devices: machines.value.length,
		drives: driveList.value.length
	};
	const troubles = {
		events: 0,
		devices: machines.value.filter(({ id }) => /[!?]/.test(signOfDevice(devices.get(id), lookAt(id)))).length,
		drives: driveList.value.filter((drive) => lookOfDrive(drive).tone === "bad").length
	};
	const tabs = Object.keys(counts).filter((one) => one === "events" || counts[one] > 0);
	const shown = tabs.includes(tab.value) ? tab.value : "events";
	return /* @__PURE__ */ a("section", {
		class: "card below",
		"aria-label": t(shown),
		children: [
			/* @__PURE__ */ a("h2", { children: [tabs.length === 1 && t("events"), tabs.length > 1 && /* @__PURE__ */ a("span", {
				class: "tabs",
				children: tabs.map((one) => /* @__PURE__ */ a("button", {
					type: "button",
					"aria-pressed": shown === one,
					onClick: () => tab.value = one,
					children: [
						t(one),
						" ",
						counts[one] || "",
						troubles[one] > 0 && /* @__PURE__ */ a("b", {
							class: "badge",
							children: ["! ", troubles[one]]
						})
					]
				}, one))
			})] }),
			shown === "events" && /* @__PURE__ */ a(Events, {}),
			shown === "devices" && /* @__PURE__ */ a(DeviceList, {}),
			shown === "drives" && /* @__PURE__ */ a(DriveList, {})
		]
	});
}
// src/parts/Panel.tsx
function Panel(props) {
	return /* @__PURE__ */ a("section", {
		class: "panel",
		"aria-label": props.title,
		children: [/* @__PURE__ */ a("h2", { children: [
			/* @__PURE__ */ a("i", {
				class: "dot",
				style: { background: props.colour }
			}),
			props.title,
			/* @__PURE__ */ a("span", {
				class: "tag",
				children: props.tag
			}),
			/* @__PURE__ */ a("button", {
				type: "button",
				class: "plain",
				"aria-label": t("close"),
				onClick: () => selected.value = null,
				children: "✕"
			})
		] }), /* @__PURE__ */ a("div", {
			class: "scroll body",
			children: props.children
		})]
	});
}
function Fact(props) {
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("dt", { children: props.name }), /* @__PURE__ */ a("dd", { children: props.children })] });
}
// src/parts/Problem.tsx
/** What the server said, and what would help. */
function Problem({ error }) {
	if (!error) return null;
	const message = error instanceof Error ? error.message : String(error);
	const remedy = error instanceof Refused ? error.remedy : "";
	return /* @__PURE__ */ a("div", {
		class: "problem",
		role: "alert",
		children: [/* @__PURE__ */ a("b", { children: tell(message) }), remedy && /* @__PURE__ */ a("span", { children: tell(remedy) })]
	});
}
// src/parts/Sure.tsx
/** A button that wants to be pressed twice. */
var PATIENCE = 3500;
function Sure(props) {
	const armed = useSignal(false);
	A$1(() => {
		if (!armed.value) return void 0;
		const timer = window.setTimeout(() => armed.value = false, PATIENCE);
		return () => window.clearTimeout(timer);
	}, [armed.value]);
	const press = () => {
		if (armed.value) props.does();
		armed.value = !armed.value;
	};
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: `sure ${props.class ?? ""} ${armed.value ? "armed" : ""}`,
		disabled: props.disabled ?? false,
		onClick: press,
		children: armed.value ? t("sure") : props.label
	});
}
// src/parts/DevicePanel.tsx
/** One door, buffer or charger: its state and since when, who has it, what is wrong, and the two commands it takes. */
var COMMANDS = {
	door: ["open", "close"],
	buffer: ["lock", "unlock"],
	charger: []
};
function DevicePanel({ id }) {
	const kind = machines.value.find((machine) => machine.id === id)?.kind;
	const now = deviceNow(id);
	presence.value;
	if (!kind) return null;
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: t(kind),
		colour: colourOfDevice(now, lookAt(id)),
		children: /* @__PURE__ */ a(DeviceBody, { id })
	});
}
/** What there is to say of a device, in its own panel or in that of its station. */
function DeviceBody({ id }) {
	const kind = machines.value.find((machine) => machine.id === id)?.kind;
	const now = deviceNow(id);
	tick.value;
	presence.value;
	if (!kind) return null;
	const barcode = layout.value?.chargers.find((charger) => charger.id === id)?.barcode;
	return /* @__PURE__ */ a($, { children: [
		now && /* @__PURE__ */ a(Notes$2, { device: now }),
		/* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("state"),
				children: /* @__PURE__ */ a(State, {
					look: lookAt(id),
					device: now
				})
			}),
			kind !== "buffer" && /* @__PURE__ */ a(Fact, {
				name: t(kind === "charger" ? "charges" : "passing"),
				children: /* @__PURE__ */ a(Vehicles$1, { ids: passers(id) })
			}),
			now?.waiting && now.waiting.length > 0 && /* @__PURE__ */ a(Fact, {
				name: t("wait_for_it"),
				children: /* @__PURE__ */ a(Vehicles$1, { ids: now.waiting })
			}),
			kind === "buffer" && now?.lock !== void 0 && /* @__PURE__ */ a(Fact, {
				name: t("lock_for"),
				children: lockOf(now)
			}),
			now?.pending && /* @__PURE__ */ a(Fact, {
				name: t("pending"),
				children: now.pending
			}),
			barcode && /* @__PURE__ */ a(Fact, {
				name: t("barcode"),
				children: barcode
			}),
			now?.link && /* @__PURE__ */ a(Fact, {
				name: t("on_line"),
				children: t("line_number", now.link, now.number ?? "")
			}),
			kind !== "charger" && !now?.fresh && /* @__PURE__ */ a(Fact, {
				name: t("seen"),
				children: now?.seen ? t("ago", span(serverNow() - Date.parse(now.seen))) : "–"
			})
		] }),
		/* @__PURE__ */ a(Commands, {
			id,
			commands: COMMANDS[kind]
		})
	] });
}
function State({ look, device }) {
	const last = device && !device.fresh && device.state ? t("last_word", t(`device_${stateOf(device.state)}`)) : "";
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("b", {
			style: { color: DEVICE_LOOKS[look] },
			children: t(`device_${look}`)
		}),
		device?.since && device.fresh && /* @__PURE__ */ a("small", { children: [" · ", t("since", clock(device.since))] }),
		last && /* @__PURE__ */ a("small", { children: [" · ", last] })
	] });
}
var STATES$1 = /* @__PURE__ */ new Set([
	"open",
	"closed",
	"cart",
	"no_cart",
	"busy",
	"error"
]);
var stateOf = (word) => STATES$1.has(word) ? word : "unknown";
function lockOf(device) {
	const { lock } = device;
	if (!lock) return t("not_locked");
	return /* @__PURE__ */ a($, { children: [
		lock.owner,
		" ",
		/* @__PURE__ */ a("small", { children: ["· ", lock.locked === null ? t("lock_unsure") : t("since", clock(lock.since))] })
	] });
}
function Vehicles$1({ ids }) {
	if (ids.length === 0) return /* @__PURE__ */ a($, { children: t("nobody") });
	return /* @__PURE__ */ a("span", {
		class: "names",
		children: ids.map((id) => /* @__PURE__ */ a("button", {
			type: "button",
			class: "text",
			onClick: () => selected.value = {
				kind: "vehicle",
				id
			},
			children: id
		}, id))
	});
}
function Notes$2({ device }) {
	const { lockout, pin } = device;
	return /* @__PURE__ */ a($, { children: [
		device.alarm && /* @__PURE__ */ a("p", {
			class: "note alarm",
			children: [
				/* @__PURE__ */ a("b", { children: tell(device.alarm) }),
				" ",
				device.remedy && /* @__PURE__ */ a("em", { children: tell(device.remedy) })
			]
		}),
		!device.fresh && device.reason && !device.alarm && device.kind !== "charger" && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("device_silent") }),
				" ",
				tell(device.reason)
			]
		}),
		device.contradiction && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("contradicts") }),
				" ",
				tell(device.contradiction)
			]
		}),
		lockout && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("locked", lockout.owner) }),
				" ",
				lockout.reason
			]
		}),
		device.out_of_service && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("out_of_service") }),
				" ",
				device.out_of_service
			]
		}),
		pin && /* @__PURE__ */ a("p", {
			class: "note waits",
			children: [
				/* @__PURE__ */ a("b", { children: t("pinned", t(pin.position === "open" ? "device_open" : "device_closed"), pin.owner) }),
				" ",
				pin.reason
			]
		})
	] });
}
function Commands({ id, commands }) {
	const error = useSignal(null);
	const done = useSignal("");
	if (commands.length === 0) return null;
	const send = (command) => {
		error.value = null;
		done.value = "";
		post(`/devices/${encodeURIComponent(id)}/commands`, { command }).then(() => done.value = t("asked", t(`cmd_${command}`)), (failure) => error.value = failure);
	};
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("div", {
			class: "buttons",
			"data-commands": id,
			children: commands.map((command) => /* @__PURE__ */ a(Sure, {
				label: t(`cmd_${command}`),
				does: () => send(command)
			}, command))
		}),
		/* @__PURE__ */ a(Problem, { error: error.value }),
		done.value && /* @__PURE__ */ a("span", {
			class: "done",
			role: "status",
			children: done.value
		})
	] });
}
// src/parts/Parameters.tsx
/** A drive's parameters as last known, and how they are read from it. */
/** How an operation stands: done, under way, or why not. */
function Outcome({ operation, label }) {
	if (!operation) return null;
	if (operation.state === "failed" || operation.state === "unknown") return /* @__PURE__ */ a("div", {
		class: "problem",
		role: "alert",
		children: [/* @__PURE__ */ a("b", { children: operation.reason || t("op_unknown") }), operation.remedy && /* @__PURE__ */ a("span", { children: operation.remedy })]
	});
	return /* @__PURE__ */ a("span", {
		class: operation.state === "done" ? "done" : "wait",
		role: "status",
		children: t(operation.state === "done" ? "op_done" : "op_running", label)
	});
}
function Parameters({ id }) {
	const list = useSignal(null);
	const operation = useSignal(null);
	const error = useSignal(null);
	const here = T(true);
	const path = `/drives/${encodeURIComponent(id)}/parameters`;
	const refresh = async () => {
		try {
			list.value = (await get(path)).items;
		} catch {}
	};
	A$1(() => {
		here.current = true;
		refresh();
		return () => {
			here.current = false;
		};
	}, [id]);
	const named = list.value?.filter((parameter) => parameter.named).map((parameter) => parameter.number) ?? [];
	const read = async () => {
		error.value = null;
		try {
			let now = await post(`/drives/${encodeURIComponent(id)}/read`, named.length ? { parameters: named } : {});
			operation.value = now;
			while (now.state === "running" && here.current) {
				now = await get(`/operations/${encodeURIComponent(now.id)}?wait=1`);
				operation.value = now;
				await refresh();
			}
		} catch (failure) {
			error.value = failure;
		}
	};
	const running = operation.value?.state === "running";
	const known = list.value?.filter((parameter) => parameter.named || parameter.raw !== null) ?? [];
	return /* @__PURE__ */ a("section", {
		class: "part",
		children: [
			/* @__PURE__ */ a("h3", { children: [
				t("parameters"),
				operation.value && running && /* @__PURE__ */ a("small", { children: t("reading", operation.value.done, operation.value.total) }),
				/* @__PURE__ */ a("button", {
					type: "button",
					disabled: running,
					onClick: () => void read(),
					children: t("read_parameters")
				})
			] }),
			/* @__PURE__ */ a(Problem, { error: error.value }),
			!running && /* @__PURE__ */ a(Outcome, {
				operation: operation.value,
				label: t("read_parameters")
			}),
			known.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_parameters")
			}),
			/* @__PURE__ */ a("table", {
				class: "bits numbered",
				children: /* @__PURE__ */ a("tbody", { children: known.map((parameter) => /* @__PURE__ */ a("tr", {
					title: parameter.description,
					children: [
						/* @__PURE__ */ a("th", { children: parameter.number }),
						/* @__PURE__ */ a("td", { children: parameter.raw === null ? "–" : parameter.text }),
						/* @__PURE__ */ a("td", { children: [
							parameter.name,
							" ",
							parameter.at && /* @__PURE__ */ a("small", { children: ["· ", clock(parameter.at)] })
						] })
					]
				}, parameter.number)) })
			})
		]
	});
}
// src/parts/DrivePanel.tsx
/** One axis drive: what it says of itself, and what is wrong. */
var COLOURS$1 = {
	calm: "var(--dim)",
	go: "var(--accent)",
	wait: "var(--wait)",
	good: "var(--good)",
	bad: "var(--bad)"
};
function DrivePanel({ id }) {
	const now = driveNow(id);
	tick.value;
	if (!now) return null;
	const { word, tone } = lookOfDrive(now);
	return /* @__PURE__ */ a(Panel, {
		title: now.id,
		tag: now.name,
		colour: COLOURS$1[tone],
		children: [
			/* @__PURE__ */ a(Notes$1, { drive: now }),
			/* @__PURE__ */ a("dl", { children: [
				/* @__PURE__ */ a(Fact, {
					name: t("state"),
					children: /* @__PURE__ */ a("b", {
						class: tone,
						children: t(`drive_${word}`)
					})
				}),
				now.mode !== null && /* @__PURE__ */ a(Fact, {
					name: t(now.mode === "error" ? "error_fact" : "operation_fact"),
					children: [
						now.meaning || "–",
						" ",
						/* @__PURE__ */ a("small", { children: now.code })
					]
				}),
				now.online && /* @__PURE__ */ a(Fact, {
					name: t("moves"),
					children: now.moving === null ? t("unknown") : t(now.moving ? "yes" : "no")
				}),
				now.output !== null && /* @__PURE__ */ a(Fact, {
					name: t("output"),
					children: now.output
				}),
				now.distance !== null && /* @__PURE__ */ a(Fact, {
					name: t("distance"),
					children: [
						hundredths(now.distance),
						" ",
						now.turn && /* @__PURE__ */ a("small", { children: ["· ", said(now.turn)] })
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("model"),
					children: now.model || t("no_model")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("on_line"),
					children: t("line_number", now.line, now.address)
				}),
				!now.online && /* @__PURE__ */ a(Fact, {
					name: t("seen"),
					children: now.seen ? t("ago", span(serverNow() - Date.parse(now.seen))) : "–"
				})
			] }),
			/* @__PURE__ */ a(StopKey, { id }),
			/* @__PURE__ */ a(Parameters, { id })
		]
	});
}
/** Stops the axis, or resets an error: at once, since a stop asks nobody whether he is sure. */
function StopKey({ id }) {
	const error = useSignal(null);
	const done = useSignal(null);
	const press = () => {
		error.value = done.value = null;
		post(`/drives/${encodeURIComponent(id)}/keys?wait=5`, { key: "stop_reset" }).then((operation) => done.value = operation, (failure) => error.value = failure);
	};
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("div", {
			class: "buttons",
			children: /* @__PURE__ */ a("button", {
				type: "button",
				class: "halt",
				onClick: press,
				children: t("stop_reset")
			})
		}),
		/* @__PURE__ */ a(Problem, { error: error.value }),
		/* @__PURE__ */ a(Outcome, {
			operation: done.value,
			label: t("stop_reset")
		})
	] });
}
function Notes$1({ drive }) {
	return /* @__PURE__ */ a($, { children: [
		drive.mode === "error" && drive.online && /* @__PURE__ */ a("p", {
			class: "note alarm",
			children: [
				/* @__PURE__ */ a("b", { children: drive.error || drive.meaning }),
				" ",
				drive.remedy && /* @__PURE__ */ a("em", { children: drive.remedy })
			]
		}),
		!drive.online && drive.reason && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t(drive.online === null ? "drive_not_heard" : "drive_offline") }),
				" ",
				drive.reason
			]
		}),
		drive.lockout && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("locked", drive.lockout.owner) }),
				" ",
				drive.lockout.reason
			]
		})
	] });
}
// src/theme.ts
/** Light or dark: the colours themselves are custom properties of the style sheet, which the map reads too. */
var KEPT$1 = "hoistway.theme";
var kept$1 = localStorage.getItem(KEPT$1);
var LIGHT = matchMedia("(prefers-color-scheme: light)");
var theme = y$1(kept$1 === "dark" || kept$1 === "light" ? kept$1 : LIGHT.matches ? "light" : "dark");
/** Show it, without choosing it for good. */
function wear(next) {
	document.documentElement.dataset["theme"] = next;
	theme.value = next;
}
function choose$1(next) {
	localStorage.setItem(KEPT$1, next);
	wear(next);
}
function begin() {
	wear(theme.value);
	LIGHT.addEventListener("change", () => {
		if (!localStorage.getItem(KEPT$1)) wear(LIGHT.matches ? "light" : "dark");
	});
}
// src/parts/Header.tsx
/** What the plant is, how it does, whether what is shown is live, who looks at it. */
function Header() {
	return /* @__PURE__ */ a("header", { children: [
		/* @__PURE__ */ a("h1", { children: [/* @__PURE__ */ a("svg", {
			viewBox: "0 0 32 32",
			width: "24",
			height: "24",
			"aria-hidden": "true",
			children: [/* @__PURE__ */ a("path", {
				d: "M3 8h26M16 8v8",
				stroke: "var(--accent)",
				"stroke-width": "3",
				"stroke-linecap": "round"
			}), /* @__PURE__ */ a("rect", {
				x: "9",
				y: "16",
				width: "14",
				height: "10",
				rx: "2",
				fill: "#f5b83d"
			})]
		}), "Hoistway"] }),
		/* @__PURE__ */ a("span", {
			class: "plant",
			children: layout.value?.name ?? ""
		}),
		/* @__PURE__ */ a(Rooms, {}),
		/* @__PURE__ */ a(ControllerState, {}),
		/* @__PURE__ */ a("span", { class: "grow" }),
		/* @__PURE__ */ a(Counts, {}),
		/* @__PURE__ */ a(Actor, {}),
		/* @__PURE__ */ a(Theme, {}),
		/* @__PURE__ */ a("button", {
			type: "button",
			class: "plain",
			onClick: () => speak(language.value === "en" ? "ko" : "en"),
			children: language.value === "en" ? "KO" : "EN"
		}),
		/* @__PURE__ */ a(LinkState, {})
	] });
}
function Rooms() {
	const grave = troubles.value.filter((wrong) => wrong.grave).length;
	return /* @__PURE__ */ a("nav", {
		class: "rooms",
		"aria-label": t("rooms"),
		children: ROOMS.map((name) => /* @__PURE__ */ a("button", {
			type: "button",
			"aria-current": room$1.value === name ? "page" : void 0,
			onClick: () => room$1.value = name,
			children: [t(name), name === "alarms" && grave > 0 && /* @__PURE__ */ a("b", {
				class: "badge",
				children: ["! ", grave]
			})]
		}, name))
	});
}
function Theme() {
	const other = theme.value === "dark" ? "light" : "dark";
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: "plain",
		title: t(`theme_${other}`),
		"aria-label": t(`theme_${other}`),
		onClick: () => choose$1(other),
		children: other === "light" ? "☀" : "☾"
	});
}
function ControllerState() {
	const now = controller.value;
	if (!now) return /* @__PURE__ */ a("span", { class: "pill" });
	const emergency = (now.emergencies ?? []).join(", ");
	const grave = now.trouble || emergency;
	const tone = grave ? "bad" : now.state === "auto" ? "good" : "wait";
	const roll = now.waiting_for.length ? t("waiting_for", now.waiting_for.join(", ")) : "";
	const why = tell(notice.value || grave || now.reason || roll);
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("span", {
		class: `pill ${tone}`,
		title: t("controller"),
		children: said(now.state)
	}), /* @__PURE__ */ a("span", {
		class: `why ${grave ? "bad" : ""}`,
		role: "status",
		title: why,
		children: why
	})] });
}
function Counts() {
	const looks = /* @__PURE__ */ new Map();
	for (const vehicle of vehicleList.value) looks.set(lookOf(vehicle), (looks.get(lookOf(vehicle)) ?? 0) + 1);
	const open = jobList.value.filter((job) => !ENDED.has(job.state)).length;
	return /* @__PURE__ */ a("span", {
		class: "counts",
		children: [
			/* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: vehicleList.value.length }),
				" ",
				t("vehicles")
			] }),
			[
				"alarm",
				"held",
				"gone"
			].map((look) => looks.has(look) && /* @__PURE__ */ a("span", {
				style: { color: LOOKS[look] },
				children: [
					/* @__PURE__ */ a("b", { children: looks.get(look) }),
					" ",
					t(`look_${look}`)
				]
			}, look)),
			/* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: open }),
				" ",
				t("open_jobs")
			] })
		]
	});
}
function Actor() {
	const name = useSignal(actor());
	return /* @__PURE__ */ a("span", {
		class: "actor",
		children: /* @__PURE__ */ a("input", {
			value: name.value,
			maxLength: 64,
			"aria-label": t("your_name"),
			autocomplete: "name",
			title: t("name_hint"),
			placeholder: t("your_name"),
			onInput: (event) => {
				name.value = event.currentTarget.value;
				nameActor(name.value);
			}
		})
	});
}
function LinkState() {
	tick.value;
	const state = link.value;
	const age = heardAt.value ? Math.round((Date.now() - heardAt.value) / 1e3) : null;
	const text = state === "live" ? t("live") : state === "connecting" ? t("connecting") : age === null ? t("lost_none") : t("lost_age", age);
	return /* @__PURE__ */ a("span", {
		class: `link ${state}`,
		role: "status",
		"aria-live": "polite",
		children: [/* @__PURE__ */ a("i", { class: "dot" }), text]
	});
}
// src/parts/Name.tsx
/** The name of something, which chooses it: of whatever kind there is one of that name. */
function Name({ id }) {
	if (!id) return null;
	const kind = vehicles.has(id) ? "vehicle" : stations.has(id) ? "station" : devices.has(id) ? "device" : drives.has(id) ? "drive" : jobs.has(id) ? "job" : null;
	if (!kind) return /* @__PURE__ */ a($, { children: id });
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: "text",
		onClick: () => selected.value = {
			kind,
			id
		},
		children: id
	});
}
// src/parts/JobPanel.tsx
/** One job: its phases, why this vehicle, what it waited for, its events, and all that can be done about it. */
var COLOURS = {
	calm: "var(--dim)",
	go: "var(--accent)",
	wait: "var(--wait)",
	good: "var(--good)",
	bad: "var(--bad)"
};
var EVERY = 3;
function JobPanel({ id }) {
	const why = useSignal(null);
	const whole = useSignal(null);
	const error = useSignal(null);
	const job = jobList.value.find((job) => job.id === id) ?? whole.value;
	const over = job ? ENDED.has(job.state) : false;
	const round = over ? 0 : Math.floor(tick.value / EVERY);
	A$1(() => {
		const path = `/jobs/${encodeURIComponent(id)}`;
		get(`${path}/why`).then((found) => why.value = found, (failure) => error.value = failure);
		get(path).then((found) => whole.value = found, (failure) => error.value = failure);
	}, [
		id,
		job?.state,
		job?.vehicle,
		round
	]);
	if (!job) return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: t("job"),
		colour: "var(--dim)",
		children: /* @__PURE__ */ a(Problem, { error: error.value })
	});
	const tone = TONES[job.state] ?? "calm";
	return /* @__PURE__ */ a(Panel, {
		title: job.id,
		tag: said(job.state),
		colour: COLOURS[tone],
		children: [
			job.reason && !over && /* @__PURE__ */ a("p", {
				class: "note waits",
				children: [
					/* @__PURE__ */ a("b", { children: t("waits") }),
					" ",
					tell(job.reason)
				]
			}),
			/* @__PURE__ */ a("dl", { children: [
				/* @__PURE__ */ a(Fact, {
					name: t("source"),
					children: /* @__PURE__ */ a(Name, { id: job.source })
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("destination"),
					children: [/* @__PURE__ */ a(Name, { id: job.destination }), job.fallbacks.length > 0 && /* @__PURE__ */ a("small", { children: [" · ", t("fallbacks", job.fallbacks.join(", "))] })]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("carrier"),
					children: job.carrier ?? t("unknown")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("vehicle"),
					children: [job.vehicle ? /* @__PURE__ */ a(Name, { id: job.vehicle }) : t("none"), job.wish && /* @__PURE__ */ a("small", { children: [" · ", t("wished", job.wish)] })]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("priority"),
					children: job.priority
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("ordered_by"),
					children: [
						job.actor,
						" ",
						/* @__PURE__ */ a("small", { children: ["· ", clock(job.created)] })
					]
				}),
				over && /* @__PURE__ */ a(Fact, {
					name: t("result"),
					children: tell(job.result || job.reason) || said(job.state)
				})
			] }),
			why.value && /* @__PURE__ */ a(Phases, { why: why.value }),
			!over && /* @__PURE__ */ a(Change, { job }),
			why.value && /* @__PURE__ */ a(Why, { why: why.value }),
			whole.value && /* @__PURE__ */ a(History, { events: whole.value.history }),
			/* @__PURE__ */ a(Problem, { error: error.value })
		]
	});
}
var seconds = (value) => value >= 100 ? `${Math.round(value)} s` : `${value.toFixed(1)} s`;
/** How long it lay, was fetched, was carried: drawn to scale. */
function Phases({ why }) {
	const phases = [
		"queued",
		"fetching",
		"carrying"
	].flatMap((name) => {
		const took = why[name];
		return took === null ? [] : [{
			name,
			took
		}];
	});
	if (phases.length === 0) return null;
	return /* @__PURE__ */ a("section", {
		class: "part",
		children: [
			/* @__PURE__ */ a("h3", { children: t("phases") }),
			/* @__PURE__ */ a("div", {
				class: "phases",
				children: phases.map(({ name, took }) => /* @__PURE__ */ a("span", {
					class: name,
					style: { flex: `${Math.max(took, .01)} 1 0` },
					title: `${t(`phase_${name}`)} ${seconds(took)}`,
					children: seconds(took)
				}, name))
			}),
			/* @__PURE__ */ a("small", {
				class: "calm",
				children: phases.map(({ name, took }) => `${t(`phase_${name}`)} ${seconds(took)}`).join(" · ")
			})
		]
	});
}
function Why({ why }) {
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("section", {
		class: "part why-list",
		children: [
			/* @__PURE__ */ a("h3", { children: t("why_vehicle") }),
			why.assignments.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("not_assigned_yet")
			}),
			why.assignments.map((choice) => /* @__PURE__ */ a(Choice, { choice }, choice.at + choice.vehicle))
		]
	}), /* @__PURE__ */ a("section", {
		class: "part why-list",
		children: [
			/* @__PURE__ */ a("h3", { children: t("why_waits") }),
			why.waits.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("never_waited")
			}),
			/* @__PURE__ */ a("table", { children: /* @__PURE__ */ a("tbody", { children: why.waits.map((wait) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("td", { children: clock(wait.since) }),
				/* @__PURE__ */ a("td", { children: wait.seconds === null ? t("still") : seconds(wait.seconds) }),
				/* @__PURE__ */ a("td", { children: tell(wait.reason) })
			] }, wait.since + wait.reason)) }) }),
			why.left_out > 0 && /* @__PURE__ */ a("small", {
				class: "calm",
				children: t("left_out", why.left_out)
			})
		]
	})] });
}
function Choice({ choice }) {
	return /* @__PURE__ */ a("div", {
		class: "choice",
		children: [
			/* @__PURE__ */ a("b", { children: [
				/* @__PURE__ */ a(Name, { id: choice.vehicle }),
				" · ",
				t("to_source", seconds(choice.seconds))
			] }),
			" ",
			/* @__PURE__ */ a("small", {
				class: "calm",
				children: clock(choice.at)
			}),
			/* @__PURE__ */ a("div", { children: [
				choice.hot && `${t("hot_lot")} · `,
				choice.before && choice.saved !== null && `${t("instead_of", choice.before, seconds(choice.saved))} · `,
				t("worth", seconds(choice.waited), seconds(choice.switch))
			] }),
			choice.candidates.length > 0 && /* @__PURE__ */ a("table", { children: /* @__PURE__ */ a("tbody", { children: choice.candidates.map((other) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("td", { children: /* @__PURE__ */ a(Name, { id: other.vehicle }) }),
				/* @__PURE__ */ a("td", { children: other.seconds === null ? t("no_way") : seconds(other.seconds) }),
				/* @__PURE__ */ a("td", { children: tell(other.why_not) })
			] }, other.vehicle)) }) })
		]
	});
}
function History({ events }) {
	return /* @__PURE__ */ a("details", {
		class: "part",
		children: [/* @__PURE__ */ a("summary", { children: [
			t("events"),
			" ",
			events.length
		] }), /* @__PURE__ */ a("table", {
			class: "bits",
			children: /* @__PURE__ */ a("tbody", { children: events.map((event) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("th", { children: clock(event.ts) }),
				/* @__PURE__ */ a("td", { children: ["#", event.seq] }),
				/* @__PURE__ */ a("td", { children: [
					sentence(event.event),
					" ",
					[
						event.vehicle,
						event.result,
						tell(event.detail)
					].filter(Boolean).join(" · ")
				] })
			] }, event.seq)) })
		})]
	});
}
var CANCELLABLE$1 = /* @__PURE__ */ new Set(["queued", "waiting"]);
var ABORTABLE$1 = /* @__PURE__ */ new Set(["transferring", "paused"]);
/** Other priority, destination or vehicle; or its end. */
function Change({ job }) {
	const error = useSignal(null);
	const done = useSignal(false);
	const priority = useSignal(String(job.priority));
	const destination = useSignal(job.destination);
	const vehicle = useSignal("");
	changes.stations.value;
	const path = `/jobs/${encodeURIComponent(job.id)}`;
	const report = (asked) => {
		error.value = null;
		done.value = false;
		asked.then(() => done.value = true, (failure) => error.value = failure);
	};
	const body = {
		...Number(priority.value) !== job.priority ? { priority: Number(priority.value) } : {},
		...destination.value !== job.destination ? { destination: destination.value } : {},
		...vehicle.value ? { vehicle: vehicle.value } : {}
	};
	return /* @__PURE__ */ a("form", {
		class: "part",
		onSubmit: (event) => {
			event.preventDefault();
			report(call("PATCH", path, body));
		},
		children: [
			/* @__PURE__ */ a("h3", { children: t("change") }),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [
					/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("priority") }), /* @__PURE__ */ a("input", {
						name: "priority",
						type: "number",
						min: "0",
						max: "99",
						required: true,
						value: priority.value,
						onInput: (event) => priority.value = event.currentTarget.value
					})] }),
					/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("vehicle") }), /* @__PURE__ */ a("input", {
						name: "vehicle",
						list: "vehicle-names",
						autocomplete: "off",
						placeholder: job.vehicle ?? t("any"),
						value: vehicle.value,
						onInput: (event) => vehicle.value = event.currentTarget.value.trim()
					})] }),
					/* @__PURE__ */ a("label", {
						class: "wide",
						children: [/* @__PURE__ */ a("span", { children: t("destination") }), /* @__PURE__ */ a("input", {
							name: "destination",
							list: "station-names",
							autocomplete: "off",
							required: true,
							value: destination.value,
							onInput: (event) => destination.value = event.currentTarget.value.trim()
						})]
					})
				]
			}),
			/* @__PURE__ */ a("datalist", {
				id: "vehicle-names",
				children: layout.value?.vehicles.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			/* @__PURE__ */ a("datalist", {
				id: "station-names",
				children: layout.value?.stations.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [
					/* @__PURE__ */ a("button", {
						type: "submit",
						class: "primary",
						disabled: Object.keys(body).length === 0,
						children: t("change")
					}),
					CANCELLABLE$1.has(job.state) && /* @__PURE__ */ a(Sure, {
						label: t("cancel"),
						does: () => report(post(`${path}/cancel`))
					}),
					ABORTABLE$1.has(job.state) && /* @__PURE__ */ a(Sure, {
						label: t("abort"),
						does: () => report(post(`${path}/abort`))
					}),
					done.value && /* @__PURE__ */ a("span", {
						class: "done",
						role: "status",
						children: t("taken")
					})
				]
			}),
			/* @__PURE__ */ a(Problem, { error: error.value })
		]
	});
}
// src/parts/Table.tsx
/** A table that can be sorted by any column and gone through by key; long ones show their beginning. */
var SHOWN$1 = 200;
function compare(a, b) {
	if (a === null || b === null) return a === b ? 0 : a === null ? 1 : -1;
	return typeof a === "number" && typeof b === "number" ? a - b : NATURAL.compare(String(a), String(b));
}
function Table({ label, rows, columns, keyOf, pick, chosen, none }) {
	const order = useSignal(null);
	const shown = useSignal(SHOWN$1);
	const by = order.value ? columns[order.value.column]?.by : void 0;
	const sign = order.value?.down ? -1 : 1;
	const sorted = by ? rows.toSorted((a, b) => sign * compare(by(a), by(b))) : rows;
	const sort = (column) => {
		const now = order.value;
		if (now?.column !== column) order.value = {
			column,
			down: false
		};
		else order.value = now.down ? null : {
			column,
			down: true
		};
	};
	return /* @__PURE__ */ a("div", {
		class: "scroll",
		tabIndex: 0,
		role: "region",
		"aria-label": label,
		children: [
			/* @__PURE__ */ a("table", {
				class: "list",
				children: [/* @__PURE__ */ a("thead", { children: /* @__PURE__ */ a("tr", { children: columns.map((column, i) => {
					const sorts = order.value?.column === i ? order.value.down ? "descending" : "ascending" : "none";
					return /* @__PURE__ */ a("th", {
						class: column.number ? "number" : "",
						"aria-sort": column.by ? sorts : void 0,
						children: column.by ? /* @__PURE__ */ a("button", {
							type: "button",
							onClick: () => sort(i),
							children: [
								column.name,
								" ",
								sorts === "ascending" ? "▲" : sorts === "descending" ? "▼" : ""
							]
						}) : /* @__PURE__ */ a("span", { children: column.name })
					}, column.name);
				}) }) }), /* @__PURE__ */ a("tbody", { children: sorted.slice(0, shown.value).map((row) => {
					const key = keyOf(row);
					return /* @__PURE__ */ a("tr", {
						"data-row": key,
						class: pick ? "pick" : "",
						"aria-selected": pick ? chosen === key : void 0,
						onClick: (event) => {
							if (!event.target.closest("button, input, select, a")) pick?.(row);
						},
						children: columns.map((column) => /* @__PURE__ */ a("td", {
							class: column.number ? "number" : "",
							children: column.of(row)
						}, column.name))
					}, key);
				}) })]
			}),
			rows.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: none
			}),
			rows.length > shown.value && /* @__PURE__ */ a("p", {
				class: "more-rows",
				children: [
					t("more_rows", rows.length - shown.value),
					" ",
					/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => shown.value += SHOWN$1,
						children: t("show_more")
					})
				]
			})
		]
	});
}
// src/parts/JobRoom.tsx
/** All jobs in a table: open ones live, ended ones from the history, older ones on demand. */
var PAGE = 200;
var STATES = [
	"queued",
	"waiting",
	"transferring",
	"paused",
	"cancelling",
	"aborting",
	"completed",
	"failed",
	"cancelled",
	"aborted"
];
function JobRoom() {
	const letters = useSignal("");
	const state = useSignal("");
	const older = useSignal([]);
	const error = useSignal(null);
	tick.value;
	const known = new Set(jobList.value.map((job) => job.id));
	const all = [...jobList.value, ...older.value.filter((job) => !known.has(job.id))];
	const wanted = letters.value.trim().toLowerCase();
	const hits = (job) => [
		job.id,
		job.source,
		job.destination,
		job.carrier,
		job.vehicle,
		job.actor
	].some((name) => name?.toLowerCase().includes(wanted) ?? false);
	const rows = all.filter((job) => (!state.value || (state.value === "open" ? !ENDED.has(job.state) : job.state === state.value)) && hits(job));
	const more = async () => {
		error.value = null;
		const oldest = all.filter((job) => ENDED.has(job.state)).reduce((least, job) => Math.min(least, job.order), Number.MAX_SAFE_INTEGER);
		try {
			const { items } = await get(`/jobs?limit=${PAGE}&after=${oldest}`);
			older.value = [...older.value, ...items.filter((job) => ENDED.has(job.state))];
		} catch (failure) {
			error.value = failure;
		}
	};
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("jobs"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: [
				/* @__PURE__ */ a("h2", { children: [
					t("jobs"),
					" ",
					rows.length
				] }),
				/* @__PURE__ */ a(Problem, { error: error.value }),
				/* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => void more(),
					children: t("older")
				}),
				/* @__PURE__ */ a("select", {
					"aria-label": t("state"),
					value: state.value,
					onChange: (event) => state.value = event.currentTarget.value,
					children: [
						/* @__PURE__ */ a("option", {
							value: "",
							children: t("all")
						}),
						/* @__PURE__ */ a("option", {
							value: "open",
							children: t("open")
						}),
						STATES.map((name) => /* @__PURE__ */ a("option", {
							value: name,
							children: said(name)
						}, name))
					]
				}),
				/* @__PURE__ */ a("input", {
					type: "search",
					"aria-label": t("filter"),
					placeholder: t("filter"),
					value: letters.value,
					onInput: (event) => letters.value = event.currentTarget.value
				})
			]
		}), /* @__PURE__ */ a(Table, {
			label: t("jobs"),
			rows,
			keyOf: (job) => job.id,
			pick: ({ id }) => selected.value = {
				kind: "job",
				id
			},
			chosen: selected.value?.kind === "job" ? selected.value.id : null,
			none: t("no_jobs"),
			columns: [
				{
					name: t("job"),
					by: (job) => job.order,
					of: ({ id }) => /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => selected.value = {
							kind: "job",
							id
						},
						children: id
					})
				},
				{
					name: t("state"),
					by: (job) => said(job.state),
					of: (job) => /* @__PURE__ */ a("span", {
						class: `state ${TONES[job.state] ?? "calm"}`,
						children: said(job.state)
					})
				},
				{
					name: t("priority"),
					by: (job) => job.priority,
					of: (job) => job.priority,
					number: true
				},
				{
					name: t("source"),
					by: (job) => job.source,
					of: (job) => /* @__PURE__ */ a(Name, { id: job.source })
				},
				{
					name: t("destination"),
					by: (job) => job.destination,
					of: (job) => /* @__PURE__ */ a(Name, { id: job.destination })
				},
				{
					name: t("carrier"),
					by: (job) => job.carrier,
					of: (job) => job.carrier ?? ""
				},
				{
					name: t("vehicle"),
					by: (job) => job.vehicle,
					of: (job) => /* @__PURE__ */ a(Name, { id: job.vehicle })
				},
				{
					name: t("ordered_at"),
					by: (job) => job.created,
					of: (job) => clock(job.created)
				},
				{
					name: t("takes"),
					by: (job) => took(job),
					of: (job) => elapsed(job, serverNow()),
					number: true
				},
				{
					name: t("why"),
					of: (job) => tell(ENDED.has(job.state) ? job.result || job.reason : job.reason)
				}
			]
		})]
	});
}
function took(job) {
	return (job.ended ? Date.parse(job.ended) : serverNow()) - Date.parse(job.created);
}
// src/parts/Jobs.tsx
/** Jobs, newest first: what each does, or why it waits. */
var SHOWN = 100;
var CANCELLABLE = /* @__PURE__ */ new Set(["queued", "waiting"]);
var ABORTABLE = /* @__PURE__ */ new Set(["transferring", "paused"]);
function Jobs() {
	const which = useSignal("all");
	const error = useSignal(null);
	tick.value;
	const all = jobList.value;
	const open = all.filter((job) => !ENDED.has(job.state));
	const list = which.value === "open" ? open : which.value === "ended" ? all.filter((job) => ENDED.has(job.state)) : all;
	const ask = (job, what) => {
		error.value = null;
		post(`/jobs/${encodeURIComponent(job.id)}/${what}`).catch((failure) => error.value = failure);
	};
	return /* @__PURE__ */ a("section", {
		class: "card jobs",
		children: [
			/* @__PURE__ */ a("h2", { children: [t("jobs"), /* @__PURE__ */ a("span", {
				class: "tabs",
				children: [
					"all",
					"open",
					"ended"
				].map((tab) => /* @__PURE__ */ a("button", {
					type: "button",
					"aria-pressed": which.value === tab,
					onClick: () => which.value = tab,
					children: [t(tab), tab === "open" && ` ${open.length}`]
				}, tab))
			})] }),
			/* @__PURE__ */ a(Problem, { error: error.value }),
			/* @__PURE__ */ a("ul", {
				class: "scroll",
				children: [list.length === 0 && /* @__PURE__ */ a("li", {
					class: "nothing",
					children: t("no_jobs")
				}), list.slice(0, SHOWN).map((job) => /* @__PURE__ */ a(Row, {
					job,
					ask
				}, job.id))]
			})
		]
	});
}
function Row({ job, ask }) {
	const over = ENDED.has(job.state);
	const why = over ? job.result || job.reason : job.reason || leg(job);
	return /* @__PURE__ */ a("li", {
		class: over ? "job over" : "job",
		"data-job": job.id,
		children: [
			/* @__PURE__ */ a("span", {
				class: `state ${TONES[job.state] ?? "calm"}`,
				children: said(job.state)
			}),
			/* @__PURE__ */ a("span", {
				class: "facts",
				children: [
					/* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						title: t("job_details"),
						onClick: () => selected.value = {
							kind: "job",
							id: job.id
						},
						children: job.id
					}),
					job.priority !== 50 && /* @__PURE__ */ a("span", {
						title: t("priority"),
						children: ["P", job.priority]
					}),
					job.carrier && /* @__PURE__ */ a("span", { children: job.carrier }),
					job.vehicle && /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => selected.value = {
							kind: "vehicle",
							id: job.vehicle
						},
						children: job.vehicle
					})
				]
			}),
			/* @__PURE__ */ a("span", {
				class: "age",
				children: elapsed(job, serverNow())
			}),
			/* @__PURE__ */ a("span", {
				class: "route",
				children: [
					/* @__PURE__ */ a(Place$1, { id: job.source }),
					/* @__PURE__ */ a("i", { children: "→" }),
					/* @__PURE__ */ a(Place$1, { id: job.destination })
				]
			}),
			/* @__PURE__ */ a("span", {
				class: "act",
				children: [CANCELLABLE.has(job.state) && /* @__PURE__ */ a(Sure, {
					label: t("cancel"),
					does: () => ask(job, "cancel")
				}), ABORTABLE.has(job.state) && /* @__PURE__ */ a(Sure, {
					label: t("abort"),
					does: () => ask(job, "abort")
				})]
			}),
			/* @__PURE__ */ a("span", {
				class: "reason",
				title: tell(why),
				children: tell(why)
			})
		]
	});
}
function leg(job) {
	const waiting = job.vehicle ? vehicles.get(job.vehicle)?.waiting : "";
	if (waiting) return waiting;
	if (job.leg === "to_source") return `${job.vehicle} → ${job.source}`;
	if (job.leg === "to_destination") return `${job.vehicle} → ${job.destination}`;
	return job.leg === "none" ? "" : `${job.vehicle}: ${said(job.leg)}`;
}
function Place$1({ id }) {
	const kind = vehicles.has(id) ? "vehicle" : "station";
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: "text",
		onClick: () => selected.value = {
			kind,
			id
		},
		children: id
	});
}
// src/parts/KeyPrompt.tsx
/** Asks for the access key; it stays in this tab. */
function KeyPrompt() {
	const key = useSignal("");
	const box = T(null);
	A$1(() => box.current?.showModal(), []);
	const use = (event) => {
		event.preventDefault();
		useKey(key.value.trim());
		keyWanted.value = false;
		start();
	};
	return /* @__PURE__ */ a("dialog", {
		ref: box,
		onCancel: (event) => event.preventDefault(),
		children: /* @__PURE__ */ a("form", {
			onSubmit: use,
			children: [
				/* @__PURE__ */ a("h2", { children: t("key_title") }),
				/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("key_label") }), /* @__PURE__ */ a("input", {
					type: "password",
					required: true,
					autocomplete: "off",
					value: key.value,
					onInput: (event) => key.value = event.currentTarget.value
				})] }),
				/* @__PURE__ */ a("p", { children: t("key_hint") }),
				/* @__PURE__ */ a("button", {
					type: "submit",
					class: "primary",
					children: t("key_use")
				})
			]
		})
	});
}
// src/paint/ink.ts
var NAMES = [
	"ground",
	"rail",
	"tape",
	"core",
	"arrow",
	"zone",
	"soft",
	"mark",
	"frame",
	"text",
	"faint",
	"park",
	"carrier",
	"reserved",
	"closed",
	"picked",
	"plate",
	"plan"
];
/** The colours of the present theme, read from the style sheet by `dip`. */
var INK = Object.fromEntries(NAMES.map((name) => [name, "#888"]));
var LOOK_INK = { ...LOOKS };
var DEVICE_INK = { ...DEVICE_LOOKS };
/** From little to much; a scale that is also told apart without red and green. */
var HEAT = [];
var STEPS = 6;
/** Take the colours of the theme that is worn now. */
function dip() {
	const style = getComputedStyle(document.documentElement);
	const of = (name) => style.getPropertyValue(name).trim() || "#888888";
	for (const name of NAMES) INK[name] = of(`--ink-${name}`);
	for (const look of Object.keys(LOOK_INK)) LOOK_INK[look] = of(`--look-${look}`);
	for (const look of Object.keys(DEVICE_INK)) DEVICE_INK[look] = of(`--device-${look}`);
	HEAT.splice(0, HEAT.length, ...Array.from({ length: STEPS }, (_, i) => of(`--heat-${i + 1}`)));
}
var LETTERS = "\"Segoe UI\", Roboto, \"Noto Sans KR\", \"Malgun Gothic\", \"NanumGothic\", Arial, system-ui, sans-serif";
function font(px, weight = 400) {
	return `${weight} ${px}px ${LETTERS}`;
}
function text(ctx, words, x, y, colour, letters) {
	ctx.font = letters;
	ctx.textAlign = "center";
	ctx.fillStyle = colour;
	ctx.fillText(words, x, y);
}
var widths = /* @__PURE__ */ new Map();
/** Width of words in px; measured once, since names do not change. */
function widthOf(ctx, words, letters) {
	const key = `${letters}${words}`;
	const known = widths.get(key);
	if (known !== void 0) return known;
	if (widths.size > 2e4) widths.clear();
	ctx.font = letters;
	const { width } = ctx.measureText(words);
	widths.set(key, width);
	return width;
}
// src/parts/StationPanel.tsx
function StationPanel({ id }) {
	const now = stationNow(id);
	tick.value;
	if (!now) return null;
	const buffer = layout.value?.stations.find((station) => station.id === id)?.buffer;
	const occupied = now.present === null ? t("unknown") : now.present ? t("yes") : t("no");
	return /* @__PURE__ */ a(Panel, {
		title: now.id,
		tag: said(now.kind),
		colour: now.present ? INK.carrier : INK.mark,
		children: [
			/* @__PURE__ */ a("dl", { children: [
				/* @__PURE__ */ a(Fact, {
					name: t("present"),
					children: [
						occupied,
						" ",
						/* @__PURE__ */ a("small", { children: [
							"(",
							now.verified ? t("verified") : t("believed"),
							")"
						] })
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("carrier"),
					children: now.carrier ?? t("none")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("provenance"),
					children: [said(now.provenance), now.at && /* @__PURE__ */ a("small", { children: [" · ", t("ago", span(serverNow() - Date.parse(now.at)))] })]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("reserved"),
					children: now.reserved || t("no")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("out_of_service"),
					children: now.out_of_service || t("no")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("barcode"),
					children: now.barcode
				}),
				now.target && /* @__PURE__ */ a(Fact, {
					name: t("target"),
					children: [
						"SHFT ",
						now.target[0],
						" · ROTA ",
						now.target[1],
						" · LIFT ",
						now.target[2],
						" ",
						/* @__PURE__ */ a("small", { children: ["v", now.target_version] })
					]
				})
			] }),
			/* @__PURE__ */ a("div", {
				class: "buttons",
				children: [/* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => orderFrom(id),
					children: t("use_source")
				}), /* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => orderTo(id),
					children: t("use_destination")
				})]
			}),
			buffer && /* @__PURE__ */ a("section", {
				class: "part",
				children: [/* @__PURE__ */ a("h3", { children: [
					t("buffer"),
					" ",
					buffer
				] }), /* @__PURE__ */ a(DeviceBody, { id: buffer })]
			})
		]
	});
}
// src/layers.ts
/** What lies over the track on the map, and what of it is shown. */
var LAYERS = [
	"grants",
	"zones",
	"closures",
	"holds"
];
var KEPT = "hoistway.layers";
function kept() {
	const all = Object.fromEntries(LAYERS.map((layer) => [layer, true]));
	try {
		const found = JSON.parse(localStorage.getItem(KEPT) ?? "{}");
		for (const layer of LAYERS) if (typeof found[layer] === "boolean") all[layer] = found[layer];
	} catch {}
	return all;
}
var layers = y$1(kept());
/** Which heat is shown over the track; none at first. */
var heatShown = y$1(null);
/** Whether the chosen vehicle is kept in the middle of the map. */
var following = y$1(false);
function show(layer, on) {
	layers.value = {
		...layers.value,
		[layer]: on
	};
	localStorage.setItem(KEPT, JSON.stringify(layers.value));
}
// src/gestures.ts
/** How people move the map and choose on it: pointer, wheel and keys. */
/** Listens on the map; `show` is told what lies under the pointer, and where that is. Returns how to stop. */
function listenTo(touched, paint, show) {
	const ends = new AbortController();
	const { signal } = ends;
	let from = null;
	touched.addEventListener("wheel", (event) => {
		event.preventDefault();
		paint.view.zoom(Math.exp(-event.deltaY * .0015), event.offsetX, event.offsetY);
		paint.move();
	}, {
		passive: false,
		signal
	});
	touched.addEventListener("pointerdown", (event) => {
		from = {
			x: event.offsetX,
			y: event.offsetY,
			moved: false
		};
		touched.setPointerCapture(event.pointerId);
	}, { signal });
	touched.addEventListener("pointermove", (event) => {
		const [x, y] = [event.offsetX, event.offsetY];
		if (from) {
			if (!from.moved && Math.hypot(x - from.x, y - from.y) < 4) return;
			paint.view.pan(x - from.x, y - from.y);
			from = {
				x,
				y,
				moved: true
			};
			show(null, 0, 0);
			following.value = false;
			paint.move();
			return;
		}
		paint.hovered = paint.at(x, y);
		touched.style.cursor = paint.hovered ? "pointer" : "grab";
		show(paint.hovered, Math.min(x + 14, paint.view.width - 250), Math.min(y + 14, paint.view.height - 90));
		paint.wake();
	}, { signal });
	touched.addEventListener("pointerup", (event) => {
		if (from && !from.moved) selected.value = paint.at(event.offsetX, event.offsetY);
		from = null;
	}, { signal });
	touched.addEventListener("pointerleave", () => {
		paint.hovered = null;
		show(null, 0, 0);
		paint.wake();
	}, { signal });
	touched.addEventListener("keydown", (event) => void (keyed(event.key, paint) && event.preventDefault()), { signal });
	return () => ends.abort();
}
function keyed(key, paint) {
	const { view } = paint;
	const step = 60;
	const move = {
		ArrowLeft: () => view.pan(step, 0),
		ArrowRight: () => view.pan(-60, 0),
		ArrowUp: () => view.pan(0, step),
		ArrowDown: () => view.pan(0, -60),
		"+": () => view.zoom(1.25, view.width / 2, view.height / 2),
		"-": () => view.zoom(.8, view.width / 2, view.height / 2),
		"0": () => paint.fit(),
		Escape: () => selected.value = null,
		f: () => following.value = !following.value
	}[key];
	move?.();
	if (move) paint.move();
	return move !== void 0;
}
// src/closed.ts
/** Which track people have closed, for the map. */
/** Pairs of barcodes: the way from the first to the second is closed. */
var closedWays = y$1([]);
// src/doors.ts
function doorMarks(layout, track) {
	return layout.doors.flatMap((door) => {
		return door.passages.flatMap(([a, b]) => track.way(a, b) ?? track.way(b, a) ?? []).map((way, i) => ({
			id: door.id,
			...track.along(way, way.edge.length / 2),
			named: i === 0
		}));
	});
}
// src/glide.ts
/** The drawn one runs on at its last pace for so long when no report comes, s. */
var RUN_ON = 1.2;
/** Reports lag and jump: share of the gap to make good per second. */
var CATCH_UP = 2.5;
/** A gap longer than this is not driven but jumped, mm. */
var JUMP = 12e3;
/** Track kept behind the front, so that the hull bends with the rail, mm. */
var TAIL = 1500;
var Glide = class {
	track;
	topSpeed;
	path = [];
	/** The ways between the barcodes of the path: `ways[i]` leads from `path[i]` on. */
	ways = [];
	s = 0;
	reported = 0;
	/** Index in the path of the barcode that was reported last: track driven both ways may have it twice. */
	here = 0;
	pace = 0;
	since = 0;
	moving = false;
	last = 0;
	constructor(track, topSpeed = 3e3) {
		this.track = track;
		this.topSpeed = topSpeed;
	}
	/** Take a report at `now` (s). */
	report(report, now) {
		const { barcode } = report;
		if (barcode === null || !this.track.points.has(barcode)) {
			this.lay([]);
			return;
		}
		const ahead = this.connected(barcode, report.granted);
		const reached = this.reach(barcode, ahead);
		let offset = this.lengthTo(reached ?? 0);
		this.here = reached ?? 0;
		if (reached === null) {
			const tail = this.tail(barcode);
			this.lay([...tail, ...ahead]);
			this.here = tail.length;
			offset = this.lengthTo(tail.length);
		}
		const at = offset + Math.max(0, report.dist ?? 0);
		if (reached === null) this.s = Math.min(at, this.lengthTo(this.path.length - 1));
		const travelled = reached === null ? 0 : at - this.reported;
		this.moving = report.moving;
		if (!report.moving || reached === null) this.pace = 0;
		else if (travelled < 1) return;
		else this.learn(travelled, now - this.since);
		this.reported = at;
		this.since = now;
	}
	/** Drive on to `now` (s). `still`: jump to where the report says. */
	drive(now, still = false) {
		const dt = Math.min(Math.max(now - this.last, 0), .25);
		this.last = now;
		const end = this.lengthTo(this.path.length - 1);
		const run = this.moving && !still ? this.pace * Math.min(now - this.since, RUN_ON) : 0;
		const goal = Math.min(this.reported + run, Math.max(end, this.s));
		const gap = goal - this.s;
		if (still || Math.abs(gap) > JUMP) this.s = goal;
		else if (gap > 0) {
			const pace = Math.min(this.topSpeed * 1.3, (this.moving ? this.pace : 0) + gap * CATCH_UP);
			this.s = Math.min(goal, this.s + Math.max(pace, 150) * dt);
		} else if (!this.moving) this.s = Math.max(goal, this.s + Math.min(-150, gap * CATCH_UP) * dt);
		this.trim();
		return this;
	}
	/** Where the point lies that is `back` mm behind its front; null while its place is not known. */
	middle(back = 0) {
		let rest = this.s - back;
		for (let i = 0; i + 1 < this.path.length; i++) {
			const way = this.ways[i];
			if (!way) break;
			if (rest <= way.edge.length || i + 2 === this.path.length) return behind(this.track.along(way, rest), -rest);
			rest -= way.edge.length;
		}
		const first = this.path[0];
		const spot = first === void 0 ? void 0 : this.track.spot(first);
		return spot ? behind(spot, back - this.s) : null;
	}
	/** Whether the drawn place still differs from the reported one. */
	get busy() {
		return this.moving || Math.abs(this.reported - this.s) > 5;
	}
	/** The report's own path, as far as edges join it; at least one edge on, to have a heading and room for `dist`. */
	connected(barcode, granted) {
		const path = [barcode];
		for (const step of granted) {
			const here = path[path.length - 1];
			if (step === here) continue;
			if (!this.track.way(here, step)) break;
			path.push(step);
		}
		const only = this.track.next.get(barcode);
		if (path.length === 1 && only?.length === 1) path.push(only[0].end);
		return path;
	}
	/** Lay the report's path behind the drawn place; returns the index of its barcode, or null if it is elsewhere. */
	reach(barcode, ahead) {
		if (this.path.length === 0) return null;
		const onward = this.path.indexOf(barcode, this.here);
		const known = onward >= 0 ? onward : this.path.lastIndexOf(barcode);
		if (known >= 0) {
			this.lay([...this.path.slice(0, known), ...ahead]);
			return known;
		}
		const from = this.index();
		const way = this.track.path(this.path[from], barcode);
		if (!way) return null;
		const path = [...this.path.slice(0, from), ...way];
		this.lay([...path.slice(0, -1), ...ahead]);
		return this.lengthTo(path.length - 1) - this.s > JUMP ? null : path.length - 1;
	}
	learn(travelled, took) {
		if (took < .02) return;
		const measured = Math.min(travelled / took, this.topSpeed);
		this.pace = this.pace === 0 ? measured : this.pace * .5 + measured * .5;
	}
	/** The barcodes before one, as long as there is only one way to have come. */
	tail(barcode) {
		const path = [];
		for (let length = 0, here = barcode; length < TAIL;) {
			const [edge, other] = this.track.before.get(here) ?? [];
			if (!edge || other || path.includes(edge.start)) break;
			path.unshift(edge.start);
			length += edge.length;
			here = edge.start;
		}
		return path;
	}
	lay(path) {
		this.path = path;
		this.ways = path.slice(1).map((end, i) => this.track.way(path[i], end));
	}
	lengthTo(index) {
		let sum = 0;
		for (let i = 0; i < index; i++) sum += this.ways[i]?.edge.length ?? 0;
		return sum;
	}
	/** Which edge of the path the drawn front is on. */
	index() {
		let i = 0;
		while (i + 2 < this.path.length && this.lengthTo(i + 1) <= this.s) i++;
		return i;
	}
	trim() {
		while (this.path.length > 2) {
			const length = this.ways[0]?.edge.length ?? 0;
			if (this.s < length + TAIL || this.reported < length) return;
			this.path.shift();
			this.ways.shift();
			this.here = Math.max(0, this.here - 1);
			this.s -= length;
			this.reported -= length;
		}
	}
};
/** Straight back from a place, for as long as there is no track known behind it. */
function behind(spot, mm) {
	const more = Math.max(0, mm);
	return {
		x: spot.x - Math.cos(spot.angle) * more,
		y: spot.y - Math.sin(spot.angle) * more,
		angle: spot.angle
	};
}
// src/heat.ts
/** A longer gap between two reports is not counted as a wait, s. */
var GAP = 5;
var Heat = class {
	/** Seconds waited, and vehicles that came, by barcode. */
	counts = {
		waiting: /* @__PURE__ */ new Map(),
		traffic: /* @__PURE__ */ new Map()
	};
	last = /* @__PURE__ */ new Map();
	clear() {
		this.last.clear();
		for (const counts of Object.values(this.counts)) counts.clear();
	}
	/** A vehicle's report at `now` (s). */
	take(vehicle, now) {
		const { barcode } = vehicle;
		if (barcode === null) return;
		const before = this.last.get(vehicle.id);
		if (before?.waits) this.add("waiting", before.barcode, Math.min(now - before.at, GAP));
		if (before && before.barcode !== barcode) this.add("traffic", barcode, 1);
		const waits = vehicle.activity === "waiting";
		if (!before) this.last.set(vehicle.id, {
			barcode,
			at: now,
			waits
		});
		else Object.assign(before, {
			barcode,
			at: now,
			waits
		});
	}
	/** Each counted barcode with its share of the most (0 to 1), on a scale on which half of it is still seen. */
	shares(kind) {
		const counts = this.counts[kind];
		let most = 0;
		for (const count of counts.values()) most = Math.max(most, count);
		return [...counts].map(([barcode, count]) => [barcode, Math.sqrt(count / most)]);
	}
	most(kind) {
		let most = 0;
		for (const count of this.counts[kind].values()) most = Math.max(most, count);
		return most;
	}
	add(kind, barcode, count) {
		this.counts[kind].set(barcode, (this.counts[kind].get(barcode) ?? 0) + count);
	}
};
// src/paint/labels.ts
/** Height of a line of letters above and below its base line, px. */
var ABOVE = 10;
var BELOW = 3;
/** Boxes are looked up by the squares of this size that they lie in, px: hundreds of vehicles have names. */
var CELL = 64;
function boxOf$1(place, width) {
	return {
		x0: place.x - width / 2 - 2,
		x1: place.x + width / 2 + 2,
		y0: place.y - ABOVE,
		y1: place.y + BELOW
	};
}
var Labels = class {
	cells = /* @__PURE__ */ new Map();
	/** Keep a box free of names. */
	block(box) {
		for (const cell of cellsOf(box)) {
			const boxes = this.cells.get(cell);
			if (boxes) boxes.push(box);
			else this.cells.set(cell, [box]);
		}
	}
	free(box) {
		const touches = (b) => b.x0 < box.x1 && b.x1 > box.x0 && b.y0 < box.y1 && b.y1 > box.y0;
		return cellsOf(box).every((cell) => !this.cells.get(cell)?.some(touches));
	}
	/** Take the first place (middle of its base line) where a name of that width fits; returns which, -1: nowhere. */
	take(places, width) {
		const which = places.findIndex((place) => this.free(boxOf$1(place, width)));
		const place = places[which];
		if (place) this.block(boxOf$1(place, width));
		return which;
	}
};
function cellsOf({ x0, y0, x1, y1 }) {
	const cells = [];
	for (let x = Math.floor(x0 / CELL); x <= Math.floor(x1 / CELL); x++) for (let y = Math.floor(y0 / CELL); y <= Math.floor(y1 / CELL); y++) cells.push(`${x}/${y}`);
	return cells;
}
// src/paint/doors.ts
/** Drawing of doors: a bar across the track, whose form says what its colour says. */
/** Half the width of a doorway, mm. */
var WING = 750;
var wingOf = (view) => Math.max(13, WING * view.scale);
function paintDoors(ctx, view, scene, now, labels) {
	for (const mark of scene.doors) {
		const look = now.look(mark.id);
		const [px, py] = [view.px(mark.x), view.py(mark.y)];
		const wing = wingOf(view);
		const [w, h] = [Math.abs(Math.sin(mark.angle)) * wing + 6, Math.abs(Math.cos(mark.angle)) * wing + 6];
		labels.block({
			x0: px - w,
			y0: py - h,
			x1: px + w,
			y1: py + h
		});
		paintBar(ctx, px, py, mark.angle, wing, look);
		if (now.picked?.id === mark.id) {
			ctx.strokeStyle = INK.picked;
			ctx.lineWidth = 2;
			ctx.strokeRect(px - w - 2, py - h - 2, w * 2 + 4, h * 2 + 4);
		}
	}
	if (view.scale < .012) return;
	for (const mark of scene.doors.filter((one) => one.named)) paintName$1(ctx, view, mark, now, labels);
}
/**
* Closed: a whole bar. Open: its halves drawn back to the posts. Busy: the halves on their way, dotted between. Unknown: an
* empty bar. Not heard: a dashed one. Error: a whole bar crossed out.
*/
function paintBar(ctx, px, py, angle, wing, look) {
	const thick = Math.max(4, wing * .22);
	ctx.save();
	ctx.translate(px, py);
	ctx.rotate(angle);
	ctx.lineCap = "butt";
	ctx.strokeStyle = ctx.fillStyle = DEVICE_INK[look];
	ctx.lineWidth = 1.6;
	const bar = (from, to) => ctx.fillRect(-thick / 2, from, thick, to - from);
	if (look === "open") {
		bar(-wing, -wing * .62);
		bar(wing * .62, wing);
	} else if (look === "busy") {
		bar(-wing, -wing * .35);
		bar(wing * .35, wing);
		ctx.setLineDash([2, 2]);
		line(ctx, 0, -wing * .35, 0, wing * .35);
	} else if (look === "closed" || look === "error") bar(-wing, wing);
	else {
		ctx.fillStyle = INK.ground;
		bar(-wing, wing);
		ctx.setLineDash(look === "silent" ? [3, 3] : []);
		ctx.strokeRect(-thick / 2, -wing, thick, wing * 2);
	}
	ctx.setLineDash([]);
	if (look === "error") {
		const s = thick * 1.3;
		ctx.strokeStyle = INK.picked;
		line(ctx, -s, -s, s, s);
		line(ctx, -s, s, s, -s);
	}
	ctx.fillStyle = INK.text;
	for (const end of [-wing, wing]) ctx.fillRect(-thick / 2 - 2, end - 1.5, thick + 4, 3);
	ctx.restore();
}
function line(ctx, x0, y0, x1, y1) {
	ctx.beginPath();
	ctx.moveTo(x0, y0);
	ctx.lineTo(x1, y1);
	ctx.stroke();
}
/** A door's name, with its sign, beside one of its posts. */
function paintName$1(ctx, view, mark, now, labels) {
	const look = now.look(mark.id);
	const device = now.device(mark.id);
	const words = `${mark.id} ${signOfDevice(device, look)}`.trim();
	const letters = font(view.scale > .045 ? 12 : 10.5, 600);
	const width = widthOf(ctx, words, letters);
	const wing = wingOf(view);
	const [px, py] = [view.px(mark.x), view.py(mark.y)];
	const [w, h] = [Math.abs(Math.sin(mark.angle)) * wing, Math.abs(Math.cos(mark.angle)) * wing];
	const across = [{
		x: px + w + 11 + width / 2,
		y: py + 4
	}, {
		x: px - w - 11 - width / 2,
		y: py + 4
	}];
	const along = [{
		x: px,
		y: py - h - 11
	}, {
		x: px,
		y: py + h + 20
	}];
	const places = w > h ? [...across, ...along] : [...along, ...across];
	const place = places[labels.take(places, width)];
	if (place) text(ctx, words, place.x, place.y, DEVICE_INK[device?.alarm ? "error" : look], letters);
}
// src/places.ts
var OFFSET = {
	port: 720,
	agv_buffer: 1150,
	charger: 1150
};
var SIDE = 640;
var NEAR = 2200;
/** Room beyond this makes no difference, mm. */
var FURTHEST = 4e3;
/** Stations with the same first part of the name, of one kind, next to each other, on one side of the track. */
function clustersOf(layout, track) {
	const groups = [];
	const named = /* @__PURE__ */ new Map();
	const sides = sidesOf(layout);
	const chargers = layout.chargers.map(({ id, barcode }) => ({
		id,
		kind: "charger",
		barcode
	}));
	for (const { id, kind, barcode } of [...layout.stations, ...chargers]) {
		const spot = track.spot(barcode);
		if (!spot) continue;
		const cut = id.lastIndexOf("-");
		const name = cut > 0 ? id.slice(0, cut) : id;
		const near = (s) => s.kind === kind && Math.hypot(s.spot.x - spot.x, s.spot.y - spot.y) < NEAR;
		const mates = named.get(name)?.find((group) => group.stands.some(near));
		if (mates) mates.stands.push({
			id,
			kind,
			barcode,
			spot
		});
		else {
			const group = {
				name,
				stands: [{
					id,
					kind,
					barcode,
					spot
				}]
			};
			groups.push(group);
			named.set(name, [...named.get(name) ?? [], group]);
		}
	}
	return groups.map(({ name, stands }) => ({
		name,
		marks: beside(stands, sides, track)
	}));
}
function sidesOf(layout) {
	const of = (kind) => new Set(layout.stations.filter((station) => station.kind === kind).map((station) => station.barcode));
	return {
		sbfl: of("sbfl"),
		sbfr: of("sbfr")
	};
}
function beside(stands, sides, track) {
	const left = onLeft(stands, sides, track);
	return stands.map(({ id, kind, barcode, spot }) => {
		const sign = left ? 1 : -1;
		const [nx, ny] = [Math.sin(spot.angle) * sign, -Math.cos(spot.angle) * sign];
		const offset = OFFSET[kind] ?? SIDE;
		const short = id.includes("-") ? id.slice(id.lastIndexOf("-") + 1) : "";
		return {
			id,
			kind,
			barcode,
			x: spot.x + nx * offset,
			y: spot.y + ny * offset,
			angle: spot.angle,
			nx,
			ny,
			short
		};
	});
}
/** Side buffers have their side; everything else is drawn where there is more room. */
function onLeft(stands, sides, track) {
	const kind = stands[0]?.kind;
	if (kind === "sbfl" || kind === "sbfr") return kind === "sbfl";
	const taken = (side) => stands.some((stand) => sides[side].has(stand.barcode));
	if (taken("sbfl") !== taken("sbfr")) return taken("sbfr");
	const least = (sign) => Math.min(...stands.map(({ spot }) => room(track, spot, sign)));
	return least(1) > least(-1) + 1;
}
/** How far the nearest other track is on that side (1 left, -1 right), mm; bounded. */
function room(track, spot, sign) {
	const [nx, ny] = [Math.sin(spot.angle) * sign, -Math.cos(spot.angle) * sign];
	let least = FURTHEST;
	for (const point of track.grid.around(spot.x, spot.y, 5500)) {
		const [dx, dy] = [point.x - spot.x, point.y - spot.y];
		const across = dx * nx + dy * ny;
		const along = Math.abs(dx * ny - dy * nx);
		if (across > 300 && across < least && along < 1500) least = across;
	}
	return least;
}
// src/paint/stations.ts
/** Drawing of stations and chargers, with what is believed of them, and their names. */
/** Below this scale a station is a dot, and only what is occupied or closed is told apart. */
var DOTS = .011;
/** Below this one their machines have no names. */
var NAMED$1 = .012;
function paintStations(ctx, view, scene, now, labels) {
	const size = Math.max(7, 460 * view.scale);
	if (view.scale < DOTS) {
		paintDots$1(ctx, view, scene, now);
		return;
	}
	const buffers = new Map(scene.layout.stations.map((station) => [station.id, station.buffer]));
	const seen = scene.clusters.filter((cluster) => cluster.marks.some((mark) => near(view, mark)));
	const frames = seen.map((cluster) => frameOf(view, cluster, size));
	seen.forEach((cluster, i) => {
		const frame = frames[i];
		labels.block(frame);
		paintFrame(ctx, frame, cluster);
		for (const mark of cluster.marks) {
			const buffer = buffers.get(mark.id);
			if (mark.kind === "charger") paintCharger(ctx, view, mark, size, now);
			else paintMark(ctx, view, mark, size, now.station(mark.id), buffer ? now.device(buffer) : void 0);
			if (now.picked?.id === mark.id) paintPicked(ctx, view, mark, size);
		}
	});
	if (view.scale < NAMED$1) return;
	seen.forEach((cluster, i) => paintName(ctx, view, cluster, frames[i], labels));
}
function near(view, { x, y }) {
	return view.sees({
		x0: x,
		x1: x,
		y0: y,
		y1: y
	}, 120);
}
/** A whole fab at once: one path for each kind of dot. */
function paintDots$1(ctx, view, scene, now) {
	const size = Math.max(1.6, 460 * view.scale * 1.1);
	const kinds = [
		[INK.mark, (station) => !station?.present && !station?.out_of_service],
		[INK.carrier, (station) => station?.present === true && !station.out_of_service],
		[INK.closed, (station) => Boolean(station?.out_of_service)]
	];
	for (const [colour, is] of kinds) {
		ctx.fillStyle = colour;
		ctx.beginPath();
		for (const mark of scene.marks) if (near(view, mark) && is(now.station(mark.id))) ctx.rect(view.px(mark.x) - size / 2, view.py(mark.y) - size / 2, size, size);
		ctx.fill();
	}
	const picked = scene.marks.find((mark) => mark.id === now.picked?.id);
	if (picked) paintPicked(ctx, view, picked, 7);
}
function frameOf(view, cluster, size) {
	const [xs, ys] = [cluster.marks.map((m) => view.px(m.x)), cluster.marks.map((m) => view.py(m.y))];
	const pad = size * (cluster.marks[0]?.kind === "agv_buffer" || cluster.marks[0]?.kind === "charger" ? .75 : .5) + Math.max(3, size * .3);
	return {
		x0: Math.min(...xs) - pad,
		y0: Math.min(...ys) - pad,
		x1: Math.max(...xs) + pad,
		y1: Math.max(...ys) + pad
	};
}
function paintFrame(ctx, box, cluster) {
	ctx.fillStyle = INK.frame;
	ctx.beginPath();
	const round = cluster.marks[0]?.kind === "sbfl" || cluster.marks[0]?.kind === "sbfr";
	ctx.roundRect(box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0, round ? 12 : 3);
	ctx.fill();
}
function paintPicked(ctx, view, mark, size) {
	ctx.strokeStyle = INK.picked;
	ctx.lineWidth = 2;
	const half = size * (mark.kind === "agv_buffer" || mark.kind === "charger" ? .75 : .5) + 4;
	ctx.strokeRect(view.px(mark.x) - half, view.py(mark.y) - half, half * 2, half * 2);
}
function paintMark(ctx, view, mark, size, station, buffer) {
	const [px, py] = [view.px(mark.x), view.py(mark.y)];
	ctx.save();
	ctx.translate(px, py);
	ctx.lineWidth = Math.max(1.2, size * .1);
	ctx.strokeStyle = station?.out_of_service ? INK.closed : station?.reserved ? INK.reserved : INK.mark;
	if (mark.kind === "agv_buffer") paintBay(ctx, mark, size, buffer);
	else shape$1(ctx, mark.kind, size);
	if (station?.present) paintLoad(ctx, mark.kind, size, station.verified);
	else if (station?.present === null) text(ctx, "?", 0, size * .26, INK.faint, font(Math.round(size * .75), 700));
	if (station?.out_of_service) strike(ctx, size);
	ctx.restore();
	if (buffer) paintTrouble(ctx, px, py, size, buffer, lookOfDevice(buffer));
	if (view.scale > .055 && mark.short) {
		const [lx, ly] = [px + mark.nx * size * .95, py + mark.ny * size * .95 + 3];
		text(ctx, mark.short, lx, ly, INK.text, font(10));
	}
}
function strike(ctx, size) {
	ctx.beginPath();
	ctx.moveTo(-size / 2, -size / 2);
	ctx.lineTo(size / 2, size / 2);
	ctx.stroke();
}
/** Ports are square; side buffers are round. */
function shape$1(ctx, kind, size) {
	ctx.beginPath();
	if (kind === "port") ctx.roundRect(-size / 2, -size / 2, size, size, size * .16);
	else ctx.arc(0, 0, size * .52, 0, 7);
	ctx.fillStyle = INK.ground;
	ctx.fill();
	ctx.stroke();
}
/** An AGV's buffer is a bay, open towards the tape; dashed while its device is not heard. */
function paintBay(ctx, mark, size, buffer) {
	const half = size * .68;
	ctx.fillStyle = INK.ground;
	ctx.fillRect(-half, -half, half * 2, half * 2);
	ctx.save();
	ctx.rotate(Math.atan2(mark.ny, mark.nx) - Math.PI / 2);
	ctx.setLineDash(buffer && lookOfDevice(buffer) === "silent" ? [size * .3, size * .22] : []);
	ctx.lineCap = "butt";
	ctx.lineWidth = Math.max(1.8, size * .16);
	if (buffer?.lock) ctx.strokeStyle = INK.reserved;
	ctx.beginPath();
	ctx.moveTo(-half, -half);
	ctx.lineTo(-half, half);
	ctx.lineTo(half, half);
	ctx.lineTo(half, -half);
	ctx.stroke();
	ctx.restore();
}
/** A FOUP is a square; a cart has wheels. */
function paintLoad(ctx, kind, size, verified) {
	ctx.fillStyle = INK.carrier;
	ctx.globalAlpha = verified ? 1 : .92;
	const s = size * (kind === "agv_buffer" ? .72 : .54);
	if (kind !== "agv_buffer") ctx.fillRect(-s / 2, -s / 2, s, s);
	else {
		ctx.fillRect(-s / 2, -s / 2, s, s * .7);
		ctx.beginPath();
		for (const side of [-1, 1]) ctx.arc(side * s * .3, s * .36, s * .17, 0, 7);
		ctx.fill();
	}
	ctx.globalAlpha = 1;
}
/** A buffer that does not answer or is in error says so by a sign at its corner. */
function paintTrouble(ctx, px, py, size, device, look) {
	const sign = signOfDevice(device, look);
	if (!sign) return;
	const [x, y] = [px + size * .75, py - size * .75];
	ctx.fillStyle = DEVICE_INK[device?.alarm ? "error" : look];
	ctx.beginPath();
	ctx.arc(x, y, 6, 0, 7);
	ctx.fill();
	text(ctx, sign, x, y + 3.5, INK.ground, font(10, 700));
}
/** A charger is a flash in a diamond: filled while somebody charges, crossed out while it is out of service. */
function paintCharger(ctx, view, mark, size, now) {
	const device = now.device(mark.id);
	const look = now.look(mark.id);
	const half = size * .85;
	ctx.save();
	ctx.translate(view.px(mark.x), view.py(mark.y));
	ctx.strokeStyle = device?.out_of_service ? INK.closed : DEVICE_INK[look];
	ctx.fillStyle = look === "charging" ? DEVICE_INK.charging : INK.ground;
	ctx.lineWidth = Math.max(1.4, size * .11);
	ctx.beginPath();
	ctx.moveTo(0, -half);
	ctx.lineTo(half, 0);
	ctx.lineTo(0, half);
	ctx.lineTo(-half, 0);
	ctx.closePath();
	ctx.fill();
	ctx.stroke();
	ctx.fillStyle = look === "charging" ? INK.ground : DEVICE_INK[look];
	flash(ctx, size * 1.05);
	if (device?.out_of_service) strike(ctx, size * 1.2);
	ctx.restore();
	if (device) paintTrouble(ctx, view.px(mark.x), view.py(mark.y), size, device, look);
}
function flash(ctx, size) {
	const s = size / 2;
	ctx.beginPath();
	ctx.moveTo(s * .25, -s);
	ctx.lineTo(-s * .5, s * .15);
	ctx.lineTo(-s * .02, s * .15);
	ctx.lineTo(-s * .25, s);
	ctx.lineTo(s * .5, -s * .15);
	ctx.lineTo(s * .02, -s * .15);
	ctx.closePath();
	ctx.fill();
}
/** The name goes away from the track if there is room, else to another side of the frame, else nowhere. */
function paintName(ctx, view, cluster, frame, labels) {
	const letters = font(view.scale > .045 ? 12 : 10.5, 600);
	const width = widthOf(ctx, cluster.name, letters);
	const half = width / 2;
	const more = view.scale > .055 && cluster.marks.some((mark) => mark.short) ? 13 : 0;
	const { nx, ny } = cluster.marks[0];
	const [mx, my] = [(frame.x0 + frame.x1) / 2, (frame.y0 + frame.y1) / 2];
	const above = {
		x: mx,
		y: frame.y0 - 5 - (ny < -.5 ? more : 0)
	};
	const below = {
		x: mx,
		y: frame.y1 + 12 + (ny > .5 ? more : 0)
	};
	const left = {
		x: frame.x0 - 5 - half - (nx < -.5 ? more : 0),
		y: my + 4
	};
	const right = {
		x: frame.x1 + 5 + half + (nx > .5 ? more : 0),
		y: my + 4
	};
	const flat = Math.abs(ny) > Math.abs(nx);
	const first = flat ? ny < 0 ? above : below : nx < 0 ? left : right;
	const away = nx < 0 ? frame.x1 - half : frame.x0 + half;
	const others = flat ? [left, right] : [
		{
			...above,
			x: away
		},
		{
			...below,
			x: away
		},
		above,
		below
	];
	const place = [first, ...others][labels.take([first, ...others], width)];
	if (place) text(ctx, cluster.name, place.x, place.y, INK.text, letters);
}
// src/paint/plant.ts
/** Below this scale a whole fab is on the map, and what is small is left out. */
var FINE = .011;
/** Draws the plant; returns what room names and marks take, for those that are drawn over it. */
function paintPlant(ctx, view, scene, now) {
	ctx.lineJoin = "round";
	const rail = Math.min(14, Math.max(view.scale < FINE ? 1.6 : 3, 260 * view.scale));
	ctx.lineCap = view.scale < FINE ? "butt" : "round";
	const ways = [...scene.track.ways.values()].filter((way) => view.sees(way.box));
	if (now.zones) paintZones(ctx, view, scene, rail);
	paintRails(ctx, view, scene.track, ways, rail);
	if (view.scale > FINE) paintArrows(ctx, view, scene.track, ways, rail);
	paintDots(ctx, view, scene.track, rail);
	const labels = new Labels();
	paintDoors(ctx, view, scene, now, labels);
	paintStations(ctx, view, scene, now, labels);
	nameBarcodes(ctx, view, scene.track, rail, labels);
	return labels;
}
/** Zones are broad bands under the track: no-stop and capped ones whole, soft ones dotted. */
function paintZones(ctx, view, scene, rail) {
	const width = Math.max(rail + (view.scale < FINE ? 3 : 8), 900 * view.scale);
	const of = (which) => scene.layout.zones.filter(which).flatMap((zone) => inside(scene.track, zone));
	ctx.strokeStyle = INK.zone;
	ctx.globalAlpha = .24;
	stroke(ctx, view, of((zone) => zone.no_stop && !zone.soft), width);
	ctx.globalAlpha = .15;
	stroke(ctx, view, of((zone) => !zone.no_stop && !zone.soft), width);
	ctx.strokeStyle = INK.soft;
	ctx.globalAlpha = .4;
	ctx.setLineDash([2, width * .8]);
	stroke(ctx, view, of((zone) => zone.soft !== null), width);
	ctx.setLineDash([]);
	ctx.globalAlpha = 1;
}
function inside(track, zone) {
	const barcodes = new Set(zone.barcodes);
	return zone.barcodes.flatMap((barcode) => (track.next.get(barcode) ?? []).filter((edge) => barcodes.has(edge.end)).flatMap((edge) => track.way(edge.start, edge.end) ?? []));
}
/** Rail hangs and is hollow; tape lies on the floor and is thin. */
function paintRails(ctx, view, track, ways, rail) {
	const hung = ways.filter((way) => !track.floor.has(way.edge.start));
	ctx.strokeStyle = INK.tape;
	stroke(ctx, view, ways.filter((way) => track.floor.has(way.edge.start)), Math.max(2.5, rail * .6));
	ctx.strokeStyle = INK.rail;
	stroke(ctx, view, hung, rail);
	if (rail <= 5) return;
	ctx.strokeStyle = INK.core;
	stroke(ctx, view, hung, rail * .45);
}
function stroke(ctx, view, ways, width) {
	ctx.lineWidth = width;
	ctx.beginPath();
	let [lastX, lastY] = [NaN, NaN];
	for (const { pts } of ways) {
		const first = pts[0];
		if (first.x !== lastX || first.y !== lastY) ctx.moveTo(view.px(first.x), view.py(first.y));
		for (let i = 1; i < pts.length; i++) {
			const point = pts[i];
			ctx.lineTo(view.px(point.x), view.py(point.y));
			[lastX, lastY] = [point.x, point.y];
		}
	}
	ctx.stroke();
}
/** One arrow where track is driven one way; two, back to back, where it is driven both ways. */
function paintArrows(ctx, view, track, ways, rail) {
	ctx.strokeStyle = INK.arrow;
	ctx.lineWidth = Math.max(1.2, rail * .16);
	const size = Math.max(3, rail * .42);
	const every = Math.max(1500, 95 / view.scale);
	let gone = every / 2;
	let both = every;
	ctx.beginPath();
	for (const way of ways) {
		const { edge } = way;
		const double = track.twoWay(edge);
		if (double && edge.start > edge.end) continue;
		if (double) both += edge.length;
		else gone += edge.length;
		if ((double ? both : gone) < every) continue;
		if (double) both = 0;
		else gone = 0;
		const { x, y, angle } = track.along(way, edge.length / 2);
		const [px, py] = [view.px(x), view.py(y)];
		const apart = double ? size * 1.3 : 0;
		arrow(ctx, px + Math.cos(angle) * apart, py + Math.sin(angle) * apart, angle, size);
		if (double) arrow(ctx, px - Math.cos(angle) * apart, py - Math.sin(angle) * apart, angle + Math.PI, size);
	}
	ctx.stroke();
}
function arrow(ctx, px, py, angle, size) {
	const [c, s] = [Math.cos(angle) * size, Math.sin(angle) * size];
	ctx.moveTo(px - c * .5 + s, py - s * .5 - c);
	ctx.lineTo(px + c * .5, py + s * .5);
	ctx.lineTo(px - c * .5 - s, py - s * .5 + c);
}
function paintDots(ctx, view, track, rail) {
	if (view.scale < FINE) return;
	for (const { x, y, park } of track.points.values()) {
		if (!park && view.scale <= .05) continue;
		if (!view.sees({
			x0: x,
			x1: x,
			y0: y,
			y1: y
		})) continue;
		ctx.fillStyle = park ? INK.park : INK.arrow;
		ctx.beginPath();
		ctx.arc(view.px(x), view.py(y), park ? Math.max(1.6, rail * .16) : Math.max(1, rail * .1), 0, 7);
		ctx.fill();
	}
}
/** Barcodes and tags have their names where there is room: tags lie further apart. */
function nameBarcodes(ctx, view, track, rail, labels) {
	const letters = font(10);
	if (view.scale <= .045) return;
	for (const [barcode, { x, y }] of track.points) {
		if (view.scale <= (track.floor.has(barcode) ? .045 : .085)) continue;
		const [px, py] = [view.px(x), view.py(y)];
		if (px < -50 || py < -50 || px > view.width + 50 || py > view.height + 50) continue;
		const width = widthOf(ctx, barcode, letters);
		const places = besides(track, barcode, rail * .5 + 5, width).map(({ x: dx, y: dy }) => ({
			x: px + dx,
			y: py + dy
		}));
		const place = places[labels.take(places, width)];
		if (place) text(ctx, barcode, place.x, place.y, INK.faint, letters);
	}
}
/** Where a barcode's name can stand, from the barcode: on the sides where no track leaves. */
function besides(track, barcode, away, width) {
	const angles = [...(track.next.get(barcode) ?? []).flatMap((edge) => track.way(edge.start, edge.end) ?? []).map((way) => track.along(way, 0).angle), ...(track.before.get(barcode) ?? []).flatMap((edge) => track.way(edge.start, edge.end) ?? []).map((way) => track.along(way, way.edge.length).angle + Math.PI)];
	return [
		{
			angle: -Math.PI / 2,
			x: 0,
			y: -away
		},
		{
			angle: Math.PI / 2,
			x: 0,
			y: away + 8
		},
		{
			angle: 0,
			x: away + width / 2,
			y: 3
		},
		{
			angle: Math.PI,
			x: -away - width / 2,
			y: 3
		}
	].filter((side) => angles.every((angle) => Math.cos(angle - side.angle) < .6));
}
// src/paint/vehicles.ts
/** Drawn last: what needs a person lies over what does not. */
var ORDER = [
	"gone",
	"idle",
	"charging",
	"moving",
	"handling",
	"waiting",
	"held",
	"alarm"
];
/** Vehicles: solid with a carrier aboard, hollow without. A hoist has a nose; an AGV, which drives both ways, has wheels. */
function paintFleet(ctx, view, bodies) {
	const groups = /* @__PURE__ */ new Map();
	for (const body of bodies) {
		const group = groups.get(body.look);
		if (group) group.push(body);
		else groups.set(body.look, [body]);
	}
	ctx.lineJoin = "round";
	for (const look of ORDER) {
		const group = groups.get(look);
		if (group) paintGroup(ctx, view, group, LOOK_INK[look], look === "gone");
	}
}
function paintGroup(ctx, view, bodies, colour, dashed) {
	if (sizeOf(view, bodies[0])[0] < SMALL) {
		paintSmall(ctx, view, bodies, colour);
		return;
	}
	const agvs = bodies.filter((body) => body.agv);
	if (agvs.length > 0) fill(ctx, INK.arrow, () => agvs.forEach((body) => wheels(ctx, view, body)));
	const loaded = bodies.filter((body) => body.vehicle.loaded);
	const empty = bodies.filter((body) => !body.vehicle.loaded);
	const hulls = (some) => () => some.forEach((body) => hull(ctx, view, body));
	fill(ctx, INK.ground, hulls(empty));
	ctx.globalAlpha = .3;
	fill(ctx, colour, hulls(empty));
	ctx.globalAlpha = 1;
	fill(ctx, colour, hulls(loaded));
	ctx.strokeStyle = colour;
	ctx.lineWidth = 1.8;
	ctx.setLineDash(dashed ? [3, 3] : []);
	ctx.beginPath();
	hulls(bodies)();
	ctx.stroke();
	ctx.setLineDash([]);
	fill(ctx, INK.carrier, () => loaded.forEach((body) => load(ctx, view, body)));
	ctx.strokeStyle = INK.ground;
	ctx.lineWidth = 1.4;
	ctx.stroke();
}
/** A whole fab at once: wedges, with a dot where a carrier is aboard. */
function paintSmall(ctx, view, bodies, colour) {
	fill(ctx, colour, () => {
		for (const body of bodies) {
			const [length, width] = sizeOf(view, body);
			const [l, w] = [length / 2, width / 2];
			shape(ctx, view, body, body.agv ? [
				-l,
				-w,
				l,
				-w,
				l,
				w,
				-l,
				w
			] : [
				-l,
				-w,
				l,
				0,
				-l,
				w
			]);
		}
	});
	fill(ctx, INK.carrier, () => {
		for (const { vehicle, spot } of bodies) if (vehicle.loaded) ctx.rect(view.px(spot.x) - 1.5, view.py(spot.y) - 1.5, 3, 3);
	});
}
function fill(ctx, colour, path) {
	ctx.fillStyle = colour;
	ctx.beginPath();
	path();
	ctx.fill();
}
/** A ring around one that is looked at, and a beat around one in alarm. */
function paintRings(ctx, view, bodies, strength, pulse) {
	for (const body of bodies) {
		const [length] = sizeOf(view, body);
		if (body.look === "alarm") ring(ctx, view, body, length * (.75 + .25 * pulse), LOOK_INK.alarm, .8 - .6 * pulse);
		const alpha = strength(body);
		if (alpha > 0) ring(ctx, view, body, length * .8, INK.picked, alpha);
	}
}
function ring(ctx, view, { spot }, radius, colour, alpha) {
	ctx.strokeStyle = colour;
	ctx.globalAlpha = alpha;
	ctx.lineWidth = 2;
	ctx.beginPath();
	ctx.arc(view.px(spot.x), view.py(spot.y), radius, 0, 7);
	ctx.stroke();
	ctx.globalAlpha = 1;
}
/** A closed shape around the vehicle: pairs along and across it, in px. */
function shape(ctx, view, { spot }, corners) {
	const [px, py] = [view.px(spot.x), view.py(spot.y)];
	const [c, s] = [Math.cos(spot.angle), Math.sin(spot.angle)];
	for (let i = 0; i < corners.length; i += 2) {
		const [along, across] = [corners[i], corners[i + 1]];
		const [x, y] = [px + along * c - across * s, py + along * s + across * c];
		if (i === 0) ctx.moveTo(x, y);
		else ctx.lineTo(x, y);
	}
	ctx.closePath();
}
/** A box with its nose forward, or, for an AGV, one that is the same at both ends. */
function hull(ctx, view, body) {
	const [length, width] = sizeOf(view, body);
	const [l, w] = [length / 2, width / 2];
	if (body.agv) shape(ctx, view, body, [
		-l,
		-w,
		l,
		-w,
		l,
		w,
		-l,
		w
	]);
	else shape(ctx, view, body, [
		-l,
		-w * .8,
		-l + w * .2,
		-w,
		l - w * .7,
		-w,
		l,
		0,
		l - w * .7,
		w,
		-l + w * .2,
		w,
		-l,
		w * .8
	]);
}
function wheels(ctx, view, body) {
	const [length, width] = sizeOf(view, body);
	const [long, thick] = [length * .24, Math.max(2.5, width * .16)];
	for (const x of [-length * .42, length * .42 - long]) for (const y of [-width / 2 - thick - 1, width / 2 + 1]) shape(ctx, view, body, [
		x,
		y,
		x + long,
		y,
		x + long,
		y + thick,
		x,
		y + thick
	]);
}
/** The carrier aboard. */
function load(ctx, view, body) {
	const [length, width] = sizeOf(view, body);
	const s = width * .28;
	const x = body.agv ? 0 : -length * .06;
	shape(ctx, view, body, [
		x - s,
		-s,
		x + s,
		-s,
		x + s,
		s,
		x - s,
		s
	]);
}
/** Shorter than this a hull has thin lines, px. */
var SMALL = 13;
/** From this scale on all vehicles have names; below it those do that are looked at or need a person. */
var NAMED = .014;
/** So few vehicles have names at any scale. */
var FEW = 60;
var SIGNS$1 = {
	alarm: "!",
	held: "‖",
	gone: "?",
	waiting: "…",
	charging: "↯"
};
/** Height of a vehicle's name with its ground, px. */
var LINE = 15;
/**
* Names beside their vehicles. One that is looked at or in trouble goes first; each stays on its side while there is room; where
* there is none at all, the name is left out unless it is one of those.
*/
var Signs = class {
	sides = /* @__PURE__ */ new Map();
	/** `still`: whether a box is free of the names of what stands still; they are covered only where there is no other room. */
	paint(ctx, view, seen, first, still) {
		const labels = new Labels();
		const rank = (body) => first(body) ? 0 : urgent(body) ? 1 : 2;
		const all = view.scale > NAMED || seen.length < FEW;
		const named = all ? seen : seen.filter((body) => rank(body) < 2).slice(0, FEW);
		for (const body of all ? seen : named) labels.block(hullOf(view, body));
		for (const body of named.toSorted((a, b) => rank(a) - rank(b))) this.sign(ctx, view, body, rank(body) < 2, first(body), labels, still);
	}
	sign(ctx, view, body, must, ringed, labels, still) {
		const { vehicle, look } = body;
		const words = SIGNS$1[look] ? `${vehicle.id} ${SIGNS$1[look]}` : vehicle.id;
		const width = widthOf(ctx, words, font(11, 700)) + 8;
		const places = placesFor(view, body, width, ringed);
		const clear = [this.sides.get(vehicle.id) ?? 0, ...places.keys()].filter((one) => one < places.length).filter((one) => labels.free(grown(places[one], width)));
		const found = clear.find((one) => still(grown(places[one], width))) ?? clear[0] ?? (must ? 0 : void 0);
		if (found === void 0) return;
		this.sides.set(vehicle.id, found);
		const { x, y } = places[found];
		labels.block(grown({
			x,
			y
		}, width));
		ctx.fillStyle = INK.plate;
		ctx.beginPath();
		ctx.roundRect(x - width / 2, y - 11.5, width, LINE, 4);
		ctx.fill();
		text(ctx, words, x, y, LOOK_INK[look], font(11, 700));
	}
};
function urgent({ look }) {
	return look === "alarm" || look === "held";
}
function grown(place, width) {
	return boxOf$1(place, width - 3);
}
function visible(view, { spot }) {
	return view.sees({
		x0: spot.x,
		x1: spot.x,
		y0: spot.y,
		y1: spot.y
	}, 50);
}
/** In px. On a whole fab they are smaller than they should be to be seen well, so that they do not lie on each other. */
var sizeOf = (view, { length, agv }) => {
	const least = view.scale < .02 ? Math.max(7.5, view.scale * 850) : 17;
	return [Math.max(least, length * .82 * view.scale), Math.max(least * (agv ? .76 : .65), (agv ? 700 : 560) * view.scale)];
};
function hullOf(view, body) {
	const [length, width] = sizeOf(view, body);
	const [c, s] = [Math.abs(Math.cos(body.spot.angle)), Math.abs(Math.sin(body.spot.angle))];
	const [w, h] = [(length * c + width * s) / 2, (length * s + width * c) / 2];
	const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
	return {
		x0: px - w,
		x1: px + w,
		y0: py - h,
		y1: py + h
	};
}
/** Around the ring of one that is looked at. */
function ringOf(view, body) {
	const radius = sizeOf(view, body)[0] * .8;
	const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
	return {
		x0: px - radius,
		x1: px + radius,
		y0: py - radius,
		y1: py + radius
	};
}
/** Beside the hull, across the track first; then a line further off. */
function placesFor(view, body, width, ringed) {
	const hull = ringed ? ringOf(view, body) : hullOf(view, body);
	const [px, py] = [(hull.x0 + hull.x1) / 2, (hull.y0 + hull.y1) / 2];
	const above = {
		x: px,
		y: hull.y0 - 7
	};
	const below = {
		x: px,
		y: hull.y1 + 15
	};
	const right = {
		x: hull.x1 + 5 + width / 2,
		y: py + 4
	};
	const left = {
		x: hull.x0 - 5 - width / 2,
		y: py + 4
	};
	return [
		...Math.abs(Math.sin(body.spot.angle)) > .7 ? [
			right,
			left,
			above,
			below
		] : [
			above,
			below,
			right,
			left
		],
		{
			x: px,
			y: above.y - LINE
		},
		{
			x: px,
			y: below.y + LINE
		}
	];
}
// src/paint/over.ts
/** The track that vehicles hold ahead. One path a look, since there are many; those that are looked at stand out. */
function paintGrants(ctx, view, track, bodies, strong) {
	const groups = /* @__PURE__ */ new Map();
	const width = Math.min(6, Math.max(view.scale < .011 ? 1.4 : 2, 110 * view.scale));
	ctx.lineCap = "round";
	ctx.lineJoin = "round";
	for (const body of bodies) {
		const ways = granted(track, body);
		if (ways.length === 0 || !ways.some((way) => view.sees(way.box))) continue;
		if (strong(body)) {
			ctx.strokeStyle = LOOK_INK[body.look];
			ctx.globalAlpha = .8;
			stroke(ctx, view, ways, width + 2);
		} else groups.set(body.look, [...groups.get(body.look) ?? [], ...ways]);
	}
	ctx.globalAlpha = .38;
	for (const [look, ways] of groups) {
		ctx.strokeStyle = LOOK_INK[look];
		stroke(ctx, view, ways, width);
	}
	ctx.globalAlpha = 1;
}
function granted(track, { vehicle }) {
	const ways = [];
	let here = vehicle.barcode ?? "";
	for (const step of vehicle.granted) {
		const way = track.way(here, step);
		if (way) ways.push(way);
		here = step;
	}
	return ways;
}
/** Where the chosen vehicle would go from the end of its grant: dashed, since nobody has granted it. */
function paintPlan(ctx, view, track, path) {
	const ways = path.slice(1).flatMap((end, i) => track.way(path[i], end) ?? []);
	ctx.strokeStyle = INK.plan;
	ctx.lineCap = "butt";
	ctx.globalAlpha = .85;
	ctx.setLineDash([7, 5]);
	stroke(ctx, view, ways, Math.max(2, Math.min(3.5, 90 * view.scale)));
	ctx.setLineDash([]);
	ctx.globalAlpha = 1;
}
/** The track behind each barcode in the colour of how much was waited, or how many came by. */
function paintHeat(ctx, view, track, heat, kind) {
	const steps = HEAT.map(() => []);
	for (const [barcode, share] of heat.shares(kind)) {
		const step = Math.min(HEAT.length - 1, Math.floor(share * HEAT.length));
		for (const edge of track.before.get(barcode) ?? []) {
			const way = track.way(edge.start, edge.end);
			if (way && view.sees(way.box)) steps[step]?.push(way);
		}
	}
	ctx.lineCap = "round";
	ctx.globalAlpha = .85;
	steps.forEach((ways, i) => {
		ctx.strokeStyle = HEAT[i];
		stroke(ctx, view, ways, Math.max(3 + i, 330 * view.scale));
	});
	ctx.globalAlpha = 1;
}
/** Closed track: crossed out, so that it is seen without its colour. */
function paintClosed(ctx, view, track, ways) {
	ctx.strokeStyle = INK.closed;
	ctx.lineCap = "butt";
	ctx.globalAlpha = .9;
	stroke(ctx, view, ways, Math.max(3, 200 * view.scale));
	ctx.globalAlpha = 1;
	ctx.lineWidth = 1.6;
	ctx.beginPath();
	let last = -1e3;
	for (const way of ways) {
		const { x, y } = track.along(way, way.edge.length / 2);
		const [px, py] = [view.px(x), view.py(y)];
		if (Math.abs(px + py - last) < 18) continue;
		last = px + py;
		ctx.moveTo(px - 6, py - 6);
		ctx.lineTo(px + 6, py + 6);
		ctx.moveTo(px + 6, py - 6);
		ctx.lineTo(px - 6, py + 6);
	}
	ctx.stroke();
}
/** Vehicles that people have stopped or locked out: a bracket around each. */
function paintHolds(ctx, view, bodies) {
	ctx.lineWidth = 2;
	ctx.strokeStyle = LOOK_INK.held;
	ctx.beginPath();
	for (const body of bodies) {
		if (!visible(view, body) || !(body.vehicle.hold || body.vehicle.lockout)) continue;
		const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
		const r = Math.max(10, 900 * view.scale);
		for (const side of [-1, 1]) {
			ctx.moveTo(px + side * r * .5, py - r);
			ctx.lineTo(px + side * r, py - r);
			ctx.lineTo(px + side * r, py + r);
			ctx.lineTo(px + side * r * .5, py + r);
		}
	}
	ctx.stroke();
}
// src/plan.ts
/** The way that the chosen vehicle would be led to its goal now: asked of the server when it changes goal or leaves that way. */
/** Barcodes from the vehicle to its goal; empty: none is known. */
var plan = y$1([]);
// src/view.ts
var FURTHEST_IN = .4;
var View = class {
	scale = .03;
	x = 0;
	y = 0;
	/** Until somebody moves the view, it keeps showing everything. */
	fitted = true;
	width = 1;
	height = 1;
	fit(box, margin) {
		const [w, h] = [Math.max(box.x1 - box.x0, 1e3), Math.max(box.y1 - box.y0, 1e3)];
		const [roomX, roomY] = [this.width - 2 * margin.side, this.height - margin.top - margin.bottom];
		this.scale = Math.max(1e-5, Math.min(roomX / w, roomY / h, .2));
		this.x = margin.side + (roomX - w * this.scale) / 2 - box.x0 * this.scale;
		this.y = margin.top + (roomY - h * this.scale) / 2 - box.y0 * this.scale;
		this.fitted = true;
	}
	zoom(factor, px, py) {
		const next = Math.min(FURTHEST_IN, Math.max(5e-4, this.scale * factor));
		const [mx, my] = [(px - this.x) / this.scale, (py - this.y) / this.scale];
		this.scale = next;
		this.x = px - mx * next;
		this.y = py - my * next;
		this.fitted = false;
	}
	pan(dx, dy) {
		this.x += dx;
		this.y += dy;
		this.fitted = false;
	}
	centre(mx, my) {
		this.x = this.width / 2 - mx * this.scale;
		this.y = this.height / 2 - my * this.scale;
		this.fitted = false;
	}
	px(mx) {
		return mx * this.scale + this.x;
	}
	py(my) {
		return my * this.scale + this.y;
	}
	/** Whether anything of a box in mm may be seen, or lies so many px beside the edge. */
	sees(box, beside = 40) {
		return this.px(box.x1) > -beside && this.py(box.y1) > -beside && this.px(box.x0) < this.width + beside && this.py(box.y0) < this.height + beside;
	}
};
// src/sheet.ts
/** A canvas larger than the map: shifted with the view while somebody moves it, and painted anew only when it has to be. */
/** After a zoom it is blurred for at most so long, ms. */
var BLURRED = 140;
var Sheet = class {
	canvas;
	margin;
	ctx;
	at = new View();
	ratio = 1;
	since = 0;
	/** `margin`: painted beyond each edge of the map, px. */
	constructor(canvas, margin) {
		this.canvas = canvas;
		this.margin = margin;
		this.ctx = canvas.getContext("2d");
		canvas.style.transformOrigin = "0 0";
	}
	resize(width, height, ratio) {
		const { margin } = this;
		const [w, h] = [width + 2 * margin, height + 2 * margin];
		this.ratio = ratio;
		this.canvas.width = Math.round(w * ratio);
		this.canvas.height = Math.round(h * ratio);
		Object.assign(this.canvas.style, {
			left: `${-margin}px`,
			top: `${-margin}px`,
			width: `${w}px`,
			height: `${h}px`
		});
		this.at.scale = 0;
	}
	/** Shift to where the view is. False: it does not show all of it, or not sharply any more. */
	follow(view, now) {
		if (this.at.scale === 0) return false;
		const { margin } = this;
		const k = view.scale / this.at.scale;
		const [dx, dy] = [view.x + margin - k * this.at.x, view.y + margin - k * this.at.y];
		this.canvas.style.transform = k === 1 ? `translate(${dx}px, ${dy}px)` : `translate(${dx}px, ${dy}px) scale(${k})`;
		if (k === 1) this.since = now;
		const [left, top] = [dx - margin, dy - margin];
		const [right, bottom] = [left + k * (view.width + 2 * margin), top + k * (view.height + 2 * margin)];
		return left <= 0 && top <= 0 && right >= view.width && bottom >= view.height && (k === 1 || now - this.since < BLURRED);
	}
	/** Whether it is shown larger or smaller than painted, and will have to be painted anew soon. */
	get blurred() {
		return this.canvas.style.transform.includes("scale");
	}
	/** An empty sheet for this view: paint it in the view that is returned. */
	begin(view, now) {
		const { at, margin } = this;
		Object.assign(at, {
			scale: view.scale,
			x: view.x + margin,
			y: view.y + margin
		});
		Object.assign(at, {
			width: view.width + 2 * margin,
			height: view.height + 2 * margin
		});
		this.ctx.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
		this.ctx.clearRect(0, 0, at.width, at.height);
		this.since = now;
		this.canvas.style.transform = "translate(0px, 0px)";
		return at;
	}
};
// src/painter.ts
/** The live map: what stands still and what lies over it on sheets that are shifted, and what moves on a canvas of its own. */
/** Room in px beyond the outermost marks: buttons and names. */
var MARGIN = {
	top: 66,
	side: 72,
	bottom: 30
};
/** Vehicles are drawn anew at most and at least so often, ms: the map is shifted between, as often as the screen wants. */
var PERIOD = 30;
var SELDOM = 120;
/** The pace by which a vehicle goes across the map, mm/s. */
var FASTEST = 3e3;
/** Below this scale only what is looked at shows its grant: others would be shorter than their vehicles. */
var GRANTS = .008;
/** What lies over the track follows the vehicles so often, ms. */
var OVER = 250;
/** A map that was moved is drawn as often as the screen wants for so long, ms. */
var MOVED = 400;
/** Somebody who looks for one thing sees it at least at this scale. */
var CLOSE = .03;
var STILL = matchMedia("(prefers-reduced-motion: reduce)");
/** Owns the canvases; drawn as often as the screen wants while something moves, and not at all else. */
var Painter = class {
	view = new View();
	hovered = null;
	scene = null;
	glides = /* @__PURE__ */ new Map();
	last = /* @__PURE__ */ new Map();
	signs = new Signs();
	bodies = [];
	names = new Labels();
	specs = /* @__PURE__ */ new Map();
	ground;
	over;
	front;
	heat = new Heat();
	stale = true;
	overAt = Number.NEGATIVE_INFINITY;
	frame = 0;
	painted = 0;
	moved = Number.NEGATIVE_INFINITY;
	namesAt = {
		scale: 0,
		x: 0,
		y: 0
	};
	count = 0;
	constructor(lower, middle, upper) {
		this.ground = new Sheet(lower, 400);
		this.over = new Sheet(middle, 320);
		this.front = new Sheet(upper, 120);
	}
	resize(width, height) {
		const ratio = Math.min(window.devicePixelRatio || 1, 2);
		for (const sheet of [
			this.ground,
			this.over,
			this.front
		]) sheet.resize(width, height, ratio);
		this.view.width = width;
		this.view.height = height;
		if (this.view.fitted) this.fit();
		this.redraw();
	}
	load() {
		if (!layout.value || !track.value) return;
		const clusters = clustersOf(layout.value, track.value);
		const marks = clusters.flatMap((cluster) => cluster.marks);
		const doors = doorMarks(layout.value, track.value);
		this.scene = {
			layout: layout.value,
			track: track.value,
			marks,
			clusters,
			doors
		};
		this.specs = new Map(layout.value.vehicles.map((spec) => [spec.id, spec]));
		this.glides.clear();
		this.last.clear();
		this.heat.clear();
		this.fit();
		this.redraw();
	}
	fit() {
		if (this.scene) this.view.fit(boxOf(this.scene), MARGIN);
		this.redraw();
	}
	/** Something that stands still has changed. */
	redraw() {
		this.stale = true;
		this.overAt = Number.NEGATIVE_INFINITY;
		this.wake();
	}
	/** Somebody moves the map: it is shifted, and painted anew where that does not do. */
	move() {
		this.moved = performance.now();
		this.wake();
	}
	/** Other colours. */
	recolour() {
		dip();
		this.redraw();
	}
	/** Bring something into the middle. */
	centre({ kind, id }) {
		const spot = this.placeOf(kind, id);
		if (!spot) return;
		this.view.scale = Math.max(this.view.scale, CLOSE);
		this.view.centre(spot.x, spot.y);
		this.move();
	}
	placeOf(kind, id) {
		if (kind === "vehicle") return this.bodies.find((body) => body.vehicle.id === id)?.spot;
		return [...this.scene?.marks ?? [], ...this.scene?.doors ?? []].find((mark) => mark.id === id) ?? this.scene?.track.points.get(id);
	}
	wake() {
		if (!this.frame) this.frame = requestAnimationFrame(() => this.paint());
	}
	stop() {
		cancelAnimationFrame(this.frame);
	}
	/** Take the vehicles' newest reports. */
	report() {
		if (!this.scene) return;
		const now = performance.now() / 1e3;
		for (const id of this.last.keys()) if (!vehicles.has(id)) this.forget(id);
		for (const vehicle of vehicles.values()) {
			if (this.last.get(vehicle.id) === vehicle) continue;
			this.last.set(vehicle.id, vehicle);
			this.heat.take(vehicle, now);
			let glide = this.glides.get(vehicle.id);
			if (!glide) {
				glide = new Glide(this.scene.track, this.specs.get(vehicle.id)?.max_speed);
				this.glides.set(vehicle.id, glide);
			}
			const moving = vehicle.link.up && vehicle.activity === "moving";
			const { barcode, dist, granted } = vehicle;
			glide.report({
				barcode,
				dist,
				granted,
				moving
			}, now);
		}
		this.wake();
	}
	at(px, py) {
		let best = null;
		let least = 20;
		for (const body of this.bodies) {
			const away = Math.hypot(this.view.px(body.spot.x) - px, this.view.py(body.spot.y) - py);
			if (away < least) [least, best] = [away, {
				kind: "vehicle",
				id: body.vehicle.id
			}];
		}
		if (best) return best;
		least = wingOf(this.view);
		for (const door of this.scene?.doors ?? []) {
			const away = Math.hypot(this.view.px(door.x) - px, this.view.py(door.y) - py);
			if (away < least) [least, best] = [away, {
				kind: "device",
				id: door.id
			}];
		}
		least = Math.max(9, 330 * this.view.scale);
		for (const mark of this.scene?.marks ?? []) {
			const away = Math.hypot(this.view.px(mark.x) - px, this.view.py(mark.y) - py);
			if (away < least) [least, best] = [away, {
				kind: mark.kind === "charger" ? "device" : "station",
				id: mark.id
			}];
		}
		return best;
	}
	forget(id) {
		this.last.delete(id);
		this.glides.delete(id);
	}
	paint() {
		this.frame = 0;
		const { scene, view } = this;
		if (!scene) return;
		const ms = performance.now();
		const moving = ms - this.moved < MOVED;
		const due = ms - this.painted >= this.period() - 5;
		if (!moving && !due) {
			this.wake();
			return;
		}
		const pick = selected.value;
		if (following.value && pick?.kind === "vehicle") this.keepInMiddle(pick.id);
		if (!this.ground.follow(view, ms) || this.stale) this.paintGround(scene, ms);
		if (!this.over.follow(view, ms) || due && ms - this.overAt > OVER) this.paintOver(scene, ms);
		if (!this.front.follow(view, ms) || due) this.paintFront(ms);
		this.front.canvas.dataset["pictures"] = String(++this.count);
		const alarm = this.bodies.some((body) => body.look === "alarm");
		if (!STILL.matches && (alarm || [...this.glides.values()].some((glide) => glide.busy)) || moving || [
			this.ground,
			this.over,
			this.front
		].some((sheet) => sheet.blurred)) this.wake();
	}
	/** How long until the fastest vehicle has moved by a pixel: more often nothing would be seen to change, ms. */
	period() {
		return Math.min(SELDOM, Math.max(PERIOD, 1e3 / (FASTEST * this.view.scale)));
	}
	looked(body) {
		const pick = selected.value;
		if (pick?.kind === "vehicle" && pick.id === body.vehicle.id) return .95;
		return this.hovered?.kind === "vehicle" && this.hovered.id === body.vehicle.id ? .5 : 0;
	}
	paintFront(ms) {
		this.painted = ms;
		this.bodies = this.placed(ms / 1e3);
		const at = this.front.begin(this.view, ms);
		const { ctx } = this.front;
		const seen = this.bodies.filter((body) => visible(at, body));
		paintFleet(ctx, at, seen);
		paintRings(ctx, at, seen, (body) => this.looked(body), STILL.matches ? 0 : ms / 1e3 % 1.4 / 1.4);
		this.signs.paint(ctx, at, seen, (body) => this.looked(body) > 0, (box) => this.names.free(this.onGround(box, at)));
	}
	paintGround(scene, ms) {
		this.stale = false;
		const pick = selected.value;
		const now = {
			station: (id) => stations.get(id),
			device: (id) => devices.get(id),
			look: lookAt,
			picked: pick?.kind === "station" || pick?.kind === "device" ? pick : null,
			zones: layers.value.zones
		};
		const at = this.ground.begin(this.view, ms);
		this.names = paintPlant(this.ground.ctx, at, scene, now);
		this.namesAt = {
			scale: at.scale,
			x: at.x,
			y: at.y
		};
	}
	paintOver(scene, ms) {
		this.overAt = ms;
		const at = this.over.begin(this.view, ms);
		const { ctx } = this.over;
		const { track: drawn } = scene;
		if (heatShown.value) paintHeat(ctx, at, drawn, this.heat, heatShown.value);
		if (layers.value.closures) paintClosed(ctx, at, drawn, closedWays.value.flatMap(([start, end]) => drawn.way(start, end) ?? []));
		if (plan.value.length > 0) paintPlan(ctx, at, drawn, plan.value);
		const strong = (body) => this.looked(body) > 0;
		const granted = this.view.scale > GRANTS ? this.bodies : this.bodies.filter(strong);
		if (layers.value.grants) paintGrants(ctx, at, drawn, granted, strong);
		if (layers.value.holds) paintHolds(ctx, at, this.bodies);
	}
	/** Where a box of a view lies on the sheet on which the names stand. */
	onGround({ x0, x1, y0, y1 }, view) {
		const { namesAt } = this;
		const k = namesAt.scale / view.scale;
		const [dx, dy] = [namesAt.x - view.x * k, namesAt.y - view.y * k];
		return {
			x0: x0 * k + dx,
			x1: x1 * k + dx,
			y0: y0 * k + dy,
			y1: y1 * k + dy
		};
	}
	keepInMiddle(id) {
		const spot = this.bodies.find((body) => body.vehicle.id === id)?.spot;
		if (spot) this.view.centre(spot.x, spot.y);
	}
	placed(now) {
		const bodies = [];
		for (const vehicle of this.last.values()) {
			const spec = this.specs.get(vehicle.id);
			const agv = spec?.kind === "agv";
			const length = Math.min(spec?.length ?? 1e3, 1200);
			const spot = (vehicle.activity === "off_rail" ? void 0 : this.glides.get(vehicle.id))?.drive(now, STILL.matches).middle(agv ? 0 : length * .41);
			if (spot) bodies.push({
				vehicle,
				look: lookOf(vehicle),
				agv,
				spot,
				length
			});
		}
		return bodies;
	}
};
/** What has to be seen: the track, and the marks beside it. */
function boxOf({ track: drawn, marks }) {
	const box = { ...drawn.box };
	for (const { x, y } of marks) {
		box.x0 = Math.min(box.x0, x - 460);
		box.x1 = Math.max(box.x1, x + 460);
		box.y0 = Math.min(box.y0, y - 460);
		box.y1 = Math.max(box.y1, y + 460);
	}
	return box;
}
// src/find.ts
/** What the page can be asked for by name. */
var MOST = 12;
/** Things whose name has these letters in it, those that begin with them first. */
function find(letters) {
	const wanted = letters.trim().toLowerCase();
	if (!wanted) return [];
	const names = (kind, ids) => [...ids].filter((id) => id.toLowerCase().includes(wanted)).map((id) => ({
		kind,
		id
	}));
	const carried = [...[...vehicles.values()].map(({ id, carrier }) => ({
		kind: "vehicle",
		id,
		carrier
	})), ...[...stations.values()].map(({ id, carrier }) => ({
		kind: "station",
		id,
		carrier
	}))].filter(({ carrier }) => carrier?.toLowerCase().includes(wanted)).map(({ kind, id, carrier }) => ({
		kind,
		id: carrier,
		at: {
			kind,
			id
		}
	}));
	const barcodes = wanted.length > 1 ? names("barcode", (layout.value?.points ?? []).map(({ barcode }) => barcode)) : [];
	const all = [
		...names("vehicle", vehicles.keys()),
		...names("station", stations.keys()),
		...names("job", jobs.keys()),
		...carried,
		...names("device", devices.keys()),
		...names("drive", drives.keys()),
		...barcodes
	];
	const rank = ({ id }) => id.toLowerCase() === wanted ? 0 : id.toLowerCase().startsWith(wanted) ? 1 : 2;
	return all.sort((a, b) => rank(a) - rank(b) || NATURAL.compare(a.id, b.id)).slice(0, MOST);
}
// src/parts/Finder.tsx
/** Finds a vehicle, station, carrier, job, device or barcode by its name, and shows it on the map. */
function Finder({ go }) {
	const letters = useSignal("");
	const which = useSignal(0);
	const box = T(null);
	A$1(() => {
		const key = (event) => {
			if (event.key !== "/" || event.ctrlKey || event.target instanceof HTMLInputElement) return;
			event.preventDefault();
			box.current?.focus();
		};
		document.addEventListener("keydown", key);
		return () => document.removeEventListener("keydown", key);
	}, []);
	const list = find(letters.value);
	const choose = (found) => {
		if (!found) return;
		const pick = found.at ?? (found.kind === "barcode" ? null : {
			kind: found.kind,
			id: found.id
		});
		if (pick) selected.value = pick;
		go(found.at ? {
			kind: found.at.kind,
			id: found.at.id
		} : found);
		letters.value = "";
		box.current?.blur();
	};
	const key = (event) => {
		const step = {
			ArrowDown: 1,
			ArrowUp: -1
		}[event.key];
		if (step) which.value = Math.min(Math.max(which.value + step, 0), list.length - 1);
		else if (event.key === "Enter") choose(list[which.value]);
		else if (event.key === "Escape") letters.value = "";
		else return;
		event.preventDefault();
	};
	return /* @__PURE__ */ a("div", {
		class: "finder",
		children: [/* @__PURE__ */ a("input", {
			ref: box,
			role: "combobox",
			"aria-expanded": list.length > 0,
			"aria-controls": "found",
			"aria-label": t("find"),
			placeholder: `${t("find")}  /`,
			autocomplete: "off",
			value: letters.value,
			onInput: (event) => {
				letters.value = event.currentTarget.value;
				which.value = 0;
			},
			onKeyDown: key
		}), letters.value.trim() && /* @__PURE__ */ a("ul", {
			id: "found",
			role: "listbox",
			"aria-label": t("find"),
			children: [list.map((found, i) => /* @__PURE__ */ a("li", {
				role: "option",
				"aria-selected": i === which.value,
				onPointerDown: (event) => {
					event.preventDefault();
					choose(found);
				},
				children: [found.id, /* @__PURE__ */ a("small", { children: found.at ? `${t("carrier")} · ${found.at.id}` : t(found.kind === "station" ? "at_station" : found.kind) })]
			}, `${found.kind} ${found.id}`)), list.length === 0 && /* @__PURE__ */ a("li", {
				class: "none",
				children: t("nothing_found")
			})]
		})]
	});
}
// src/parts/Keys.tsx
/** The keys that the map takes. */
var KEYS = [
	["/", "key_find"],
	["← ↑ → ↓", "key_pan"],
	["+ −", "key_zoom"],
	["0", "key_fit"],
	["F", "key_follow"],
	["Esc", "key_none"]
];
function Keys() {
	const open = useSignal(false);
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("button", {
		type: "button",
		"aria-label": t("keys"),
		title: t("keys"),
		onClick: () => open.value = true,
		children: "?"
	}), open.value && /* @__PURE__ */ a(List, { close: () => open.value = false })] });
}
function List({ close }) {
	const box = T(null);
	A$1(() => box.current?.showModal(), []);
	return /* @__PURE__ */ a("dialog", {
		ref: box,
		"aria-label": t("keys"),
		onClose: close,
		children: /* @__PURE__ */ a("form", {
			method: "dialog",
			children: [
				/* @__PURE__ */ a("h2", { children: t("keys") }),
				/* @__PURE__ */ a("dl", {
					class: "keys",
					children: KEYS.map(([key, word]) => /* @__PURE__ */ a("div", { children: [/* @__PURE__ */ a("dt", { children: /* @__PURE__ */ a("kbd", { children: key }) }), /* @__PURE__ */ a("dd", { children: t(word) })] }, key))
				}),
				/* @__PURE__ */ a("button", {
					type: "submit",
					children: t("close")
				})
			]
		})
	});
}
// src/parts/Layers.tsx
/** Which layers the map shows. */
var HEATS = [
	null,
	"waiting",
	"traffic"
];
function Layers() {
	const open = useSignal(false);
	return /* @__PURE__ */ a("div", {
		class: "layers",
		onKeyDown: (event) => event.key === "Escape" && (open.value = false),
		children: [/* @__PURE__ */ a("button", {
			type: "button",
			"aria-expanded": open.value,
			onClick: () => open.value = !open.value,
			children: t("layers")
		}), open.value && /* @__PURE__ */ a("div", {
			role: "group",
			"aria-label": t("layers"),
			children: [
				LAYERS.map((layer) => /* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("input", {
					type: "checkbox",
					checked: layers.value[layer],
					onChange: (event) => show(layer, event.currentTarget.checked)
				}), t(`layer_${layer}`)] }, layer)),
				/* @__PURE__ */ a("b", { children: t("heat") }),
				HEATS.map((kind) => /* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("input", {
					type: "radio",
					name: "heat",
					checked: heatShown.value === kind,
					onChange: () => heatShown.value = kind
				}), t(kind === null ? "heat_off" : kind === "waiting" ? "heat_waiting" : "heat_traffic")] }, kind ?? "off"))
			]
		})]
	});
}
// src/parts/Legend.tsx
/** What the colours and forms on the map mean; what the plant does not have is left out. */
var SIGNS = {
	alarm: "!",
	held: "‖",
	gone: "?",
	waiting: "…",
	charging: "↯"
};
function Legend() {
	const plant = layout.value;
	const agvs = plant?.vehicles.some((vehicle) => vehicle.kind === "agv") ?? false;
	const looks = Object.keys(LOOKS).filter((look) => look !== "charging" || agvs);
	const zones = layers.value.zones ? plant?.zones ?? [] : [];
	return /* @__PURE__ */ a("div", {
		class: "legend",
		children: [
			looks.map((look) => /* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("i", {
					class: "dot",
					style: { background: LOOKS[look] }
				}),
				t(`look_${look}`),
				" ",
				SIGNS[look] ?? ""
			] }, look)),
			/* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", { class: "box" }), t("legend_carrier")] }),
			zones.some((zone) => zone.no_stop && !zone.soft) && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", { class: "zone" }), t("legend_zone")] }),
			zones.some((zone) => zone.soft) && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", { class: "zone soft" }), t("legend_soft")] }),
			plant && plant.doors.length > 0 && /* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("i", { class: "door shut" }),
				/* @__PURE__ */ a("i", { class: "door ajar" }),
				t("legend_door")
			] }),
			plant && plant.chargers.length > 0 && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", {
				class: "flash",
				children: "↯"
			}), t("charger")] }),
			heatShown.value && /* @__PURE__ */ a("span", {
				class: "heat-key",
				children: [
					t("little"),
					[
						1,
						2,
						3,
						4,
						5,
						6
					].map((step) => /* @__PURE__ */ a("i", { style: { background: `var(--heat-${step})` } }, step)),
					t("much")
				]
			})
		]
	});
}
// src/parts/TrackMap.tsx
/** The live map with its buttons, its legend, and what is said of the thing under the pointer. */
function tipOf(hit, x, y) {
	const lines = hit && linesFor(hit.kind, hit.id);
	return lines ? {
		x,
		y,
		title: hit.id,
		lines: lines.filter(Boolean)
	} : null;
}
function linesFor(kind, id) {
	if (kind === "vehicle") {
		const vehicle = vehicles.get(id);
		if (!vehicle) return null;
		const load = vehicle.loaded ? vehicle.carrier ?? t("loaded") : t("empty");
		return [
			`${said(vehicle.activity)} · ${load}`,
			tell(vehicle.waiting),
			tell(vehicle.hold?.reason ?? "")
		];
	}
	if (kind === "device") {
		const device = devices.get(id);
		const charger = layout.value?.chargers.some((one) => one.id === id);
		return [
			`${t(charger ? "charger" : "door")} · ${t(`device_${lookAt(id)}`)}`,
			tell(device?.alarm || device?.reason || ""),
			passers(id).join(", ")
		];
	}
	const station = stations.get(id);
	if (!station) return null;
	const content = station.present === null ? t("unknown") : station.present ? station.carrier ?? t("loaded") : t("empty");
	const name = layout.value?.stations.find((one) => one.id === id)?.buffer;
	const buffer = name ? devices.get(name) : void 0;
	return [`${said(station.kind)} · ${content}`, buffer ? `${buffer.id} · ${t(`device_${lookAt(buffer.id)}`)}` : ""];
}
function TrackMap() {
	const frame = T(null);
	const lower = T(null);
	const middle = T(null);
	const upper = T(null);
	const touch = T(null);
	const painter = T(null);
	const tip = useSignal(null);
	A$1(() => {
		const box = frame.current;
		const paint = new Painter(lower.current, middle.current, upper.current);
		painter.current = paint;
		const size = new ResizeObserver(() => paint.resize(box.clientWidth, box.clientHeight));
		size.observe(box);
		const stops = [
			x(() => {
				track.value;
				paint.load();
			}),
			x(() => {
				changes.vehicles.value;
				track.value;
				paint.report();
			}),
			x(() => {
				changes.stations.value;
				changes.devices.value;
				presence.value;
				selected.value;
				layers.value;
				heatShown.value;
				closedWays.value;
				plan.value;
				paint.redraw();
			}),
			x(() => {
				theme.value;
				paint.recolour();
			}),
			x(() => {
				following.value;
				paint.move();
			}),
			listenTo(touch.current, paint, (hit, x, y) => tip.value = tipOf(hit, x, y))
		];
		return () => {
			size.disconnect();
			for (const stop of stops) stop();
			paint.stop();
		};
	}, []);
	const zoom = (factor) => {
		const paint = painter.current;
		paint?.view.zoom(factor, paint.view.width / 2, paint.view.height / 2);
		paint?.move();
	};
	const go = (found) => {
		if (found.kind !== "barcode") painter.current?.centre({
			kind: found.kind,
			id: found.id
		});
		else painter.current?.centre({
			kind: "station",
			id: found.id
		});
	};
	const pick = selected.value;
	return /* @__PURE__ */ a("div", {
		class: "map",
		ref: frame,
		children: [
			/* @__PURE__ */ a("canvas", {
				ref: lower,
				"aria-hidden": "true"
			}),
			/* @__PURE__ */ a("canvas", {
				ref: middle,
				"aria-hidden": "true"
			}),
			/* @__PURE__ */ a("canvas", {
				ref: upper,
				class: "front",
				"aria-hidden": "true"
			}),
			/* @__PURE__ */ a("div", {
				ref: touch,
				class: "touch",
				tabIndex: 0,
				role: "application",
				"aria-label": t("map_label")
			}),
			/* @__PURE__ */ a("div", {
				class: "map-tools",
				children: [
					/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => zoom(1.4),
						"aria-label": t("zoom_in"),
						title: t("zoom_in"),
						children: "+"
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => zoom(1 / 1.4),
						"aria-label": t("zoom_out"),
						title: t("zoom_out"),
						children: "−"
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => painter.current?.fit(),
						children: t("fit")
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						"aria-pressed": following.value,
						disabled: pick?.kind !== "vehicle",
						title: t("follow_hint"),
						onClick: () => following.value = !following.value,
						children: t("follow")
					}),
					/* @__PURE__ */ a(Layers, {}),
					/* @__PURE__ */ a(Finder, { go }),
					/* @__PURE__ */ a(Keys, {})
				]
			}),
			/* @__PURE__ */ a(Legend, {}),
			tip.value && /* @__PURE__ */ a("div", {
				class: "tip",
				style: {
					left: `${tip.value.x}px`,
					top: `${tip.value.y}px`
				},
				children: [/* @__PURE__ */ a("b", { children: tip.value.title }), tip.value.lines.map((line) => /* @__PURE__ */ a("div", { children: line }, line))]
			})
		]
	});
}
// src/parts/Transfer.tsx
/** The form that orders a transfer. */
var key = freshKey();
var written = "";
/** The same order keeps its key, so that sending it again after a lost answer makes no second job. */
function keyOf(body) {
	const now = JSON.stringify(body);
	if (now !== written) key = freshKey();
	written = now;
	return key;
}
function Transfer() {
	const priority = useSignal("50");
	const sending = useSignal(false);
	const error = useSignal(null);
	const done = useSignal("");
	changes.stations.value;
	const known = stations.get(order.source.value)?.carrier ?? "";
	const send = async (event) => {
		event.preventDefault();
		const body = {
			source: order.source.value,
			destination: order.destination.value,
			priority: Number(priority.value),
			...order.carrier.value.trim() ? { carrier: order.carrier.value.trim() } : {}
		};
		sending.value = true;
		error.value = null;
		done.value = "";
		try {
			const job = await post("/jobs", body, { "Idempotency-Key": keyOf(body) });
			done.value = t("ordered", job.id);
			written = "";
			order.carrier.value = "";
		} catch (failure) {
			error.value = failure;
		} finally {
			sending.value = false;
		}
	};
	const wrong = error.value instanceof Refused ? error.value.field : "";
	return /* @__PURE__ */ a("form", {
		class: "card transfer",
		onSubmit: (event) => void send(event),
		children: [
			/* @__PURE__ */ a("h2", { children: t("new_transfer") }),
			/* @__PURE__ */ a(Place, {
				label: t("source"),
				value: order.source.value,
				choose: orderFrom,
				wrong: wrong === "source",
				vehicles: true
			}),
			/* @__PURE__ */ a(Place, {
				label: t("destination"),
				value: order.destination.value,
				choose: orderTo,
				wrong: wrong === "destination",
				partner: order.source.value
			}),
			/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("carrier") }), /* @__PURE__ */ a("input", {
				name: "carrier",
				value: order.carrier.value,
				maxLength: 64,
				placeholder: known || t("carrier_optional"),
				"aria-invalid": wrong === "carrier",
				autocomplete: "off",
				onInput: (event) => order.carrier.value = event.currentTarget.value
			})] }),
			/* @__PURE__ */ a("label", {
				class: "narrow",
				children: [/* @__PURE__ */ a("span", { children: t("priority") }), /* @__PURE__ */ a("input", {
					name: "priority",
					type: "number",
					min: "0",
					max: "99",
					required: true,
					value: priority.value,
					"aria-invalid": wrong === "priority",
					onInput: (event) => priority.value = event.currentTarget.value
				})]
			}),
			/* @__PURE__ */ a("button", {
				type: "submit",
				class: "primary",
				disabled: sending.value,
				children: sending.value ? t("ordering") : t("order")
			}),
			/* @__PURE__ */ a("div", {
				class: "outcome",
				children: error.value ? /* @__PURE__ */ a(Problem, { error: error.value }) : /* @__PURE__ */ a("span", {
					class: "done",
					role: "status",
					children: done.value
				})
			})
		]
	});
}
function Place(props) {
	const world = worldOf(layout.value, props.partner ?? "");
	const places = (layout.value?.stations ?? []).filter(({ kind }) => world === null || worldOfKind(kind) === world);
	const groups = [
		{
			name: t("ports"),
			stations: places.filter(({ kind }) => kind === "port")
		},
		{
			name: t("buffers"),
			stations: places.filter(({ kind }) => kind === "sbfl" || kind === "sbfr")
		},
		{
			name: t("agv_buffers"),
			stations: places.filter(({ kind }) => kind === "agv_buffer")
		}
	];
	const loaded = props.vehicles ? vehicleList.value.filter((vehicle) => vehicle.loaded) : [];
	const shown = (id) => {
		const now = stations.get(id);
		return now?.present ? `${id} · ${now.carrier ?? "■"}` : id;
	};
	return /* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: props.label }), /* @__PURE__ */ a("select", {
		required: true,
		value: props.value,
		"aria-invalid": props.wrong,
		onChange: (event) => props.choose(event.currentTarget.value),
		children: [
			/* @__PURE__ */ a("option", {
				value: "",
				children: t("choose")
			}),
			groups.filter((group) => group.stations.length > 0).map((group) => /* @__PURE__ */ a("optgroup", {
				label: group.name,
				children: group.stations.map(({ id }) => /* @__PURE__ */ a("option", {
					value: id,
					children: shown(id)
				}, id))
			}, group.name)),
			loaded.length > 0 && /* @__PURE__ */ a("optgroup", {
				label: t("loaded_vehicles"),
				children: loaded.map(({ id, carrier }) => /* @__PURE__ */ a("option", {
					value: id,
					children: carrier ? `${id} · ${carrier}` : id
				}, id))
			})
		]
	})] });
}
// src/parts/Vehicles.tsx
/** All vehicles in a table: what each does, and why one waits. */
var GROUPS = [
	"all",
	"alarm",
	"held",
	"waiting",
	"moving",
	"handling",
	"charging",
	"idle",
	"gone"
];
/** Idle at a parking place is said so: else one would look for why it does not move. */
function doing(vehicle) {
	return vehicle.parked && vehicle.activity === "idle" ? t("idle_parked") : said(vehicle.activity);
}
function Vehicles() {
	const letters = useSignal("");
	const group = useSignal("all");
	const wanted = letters.value.trim().toLowerCase();
	const rows = vehicleList.value.filter((vehicle) => (group.value === "all" || lookOf(vehicle) === group.value) && [
		vehicle.id,
		vehicle.job,
		vehicle.carrier,
		vehicle.goal,
		vehicle.barcode
	].some((name) => name?.toLowerCase().includes(wanted) ?? !wanted));
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("vehicles"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: [
				/* @__PURE__ */ a("h2", { children: [
					t("vehicles"),
					" ",
					rows.length
				] }),
				/* @__PURE__ */ a("select", {
					"aria-label": t("activity"),
					value: group.value,
					onChange: (event) => group.value = event.currentTarget.value,
					children: GROUPS.map((name) => /* @__PURE__ */ a("option", {
						value: name,
						children: name === "all" ? t("all") : t(`look_${name}`)
					}, name))
				}),
				/* @__PURE__ */ a("input", {
					type: "search",
					"aria-label": t("filter"),
					placeholder: t("filter"),
					value: letters.value,
					onInput: (event) => letters.value = event.currentTarget.value
				})
			]
		}), /* @__PURE__ */ a(Table, {
			label: t("vehicles"),
			rows,
			keyOf: (vehicle) => vehicle.id,
			pick: ({ id }) => selected.value = {
				kind: "vehicle",
				id
			},
			chosen: selected.value?.kind === "vehicle" ? selected.value.id : null,
			none: t("nothing_found"),
			columns: [
				{
					name: t("vehicle"),
					by: ({ id }) => id,
					of: (vehicle) => /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => selected.value = {
							kind: "vehicle",
							id: vehicle.id
						},
						children: [
							/* @__PURE__ */ a("i", {
								class: "dot",
								style: { background: LOOKS[lookOf(vehicle)] }
							}),
							" ",
							vehicle.id
						]
					})
				},
				{
					name: t("activity"),
					by: doing,
					of: (vehicle) => /* @__PURE__ */ a("span", {
						style: { color: LOOKS[lookOf(vehicle)] },
						children: doing(vehicle)
					})
				},
				{
					name: t("place"),
					by: ({ barcode }) => barcode,
					of: ({ barcode }) => barcode ?? t("unknown")
				},
				{
					name: t("carrier"),
					by: ({ carrier, loaded }) => carrier ?? (loaded ? "~" : null),
					of: ({ carrier, loaded }) => loaded ? carrier ?? t("loaded") : ""
				},
				{
					name: t("job"),
					by: ({ job }) => job,
					of: ({ job }) => /* @__PURE__ */ a(Name, { id: job })
				},
				{
					name: t("goal"),
					by: ({ goal }) => goal,
					of: ({ goal }) => /* @__PURE__ */ a(Name, { id: goal })
				},
				{
					name: t("why"),
					of: (vehicle) => tell(vehicle.hold?.reason ?? vehicle.waiting)
				}
			]
		})]
	});
}
// src/parts/VehiclePanel.tsx
/** One vehicle: what it does and why not, its status bit by bit, its line, and the two decisions a person may take here. */
var FRAMES_EVERY = 2e3;
function VehiclePanel({ id }) {
	const now = vehicleNow(id);
	tick.value;
	if (!now) return null;
	const load = now.loaded === null ? t("unknown") : now.loaded ? now.carrier ?? t("loaded") : t("empty");
	return /* @__PURE__ */ a(Panel, {
		title: now.id,
		tag: doing(now),
		colour: LOOKS[lookOf(now)],
		children: [
			/* @__PURE__ */ a(Notes, { vehicle: now }),
			/* @__PURE__ */ a("dl", { children: [
				/* @__PURE__ */ a(Fact, {
					name: t("state"),
					children: [
						said(now.state),
						" · ",
						said(now.service)
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("mode"),
					children: [
						upper(now.mode),
						" · ",
						upper(now.oper),
						now.code ? ` · ${hex(now.code)} ${now.code_name}` : ""
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("carrier"),
					children: load
				}),
				/* @__PURE__ */ a(Fact, {
					name: t(lineOf(id) ? "tag" : "place"),
					children: [now.barcode ?? t("unknown"), now.dist ? ` + ${now.dist} mm` : ""]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("job"),
					children: now.job ? /* @__PURE__ */ a(Name, { id: now.job }) : t("none")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("goal"),
					children: now.goal ? /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => selected.value = {
							kind: "station",
							id: now.goal
						},
						children: now.goal
					}) : t("none")
				})
			] }),
			/* @__PURE__ */ a(Decide, { vehicle: now }),
			now.agv ? /* @__PURE__ */ a(AgvFacts, { agv: now.agv }) : /* @__PURE__ */ a(Bits, { vehicle: now }),
			/* @__PURE__ */ a(LinkFacts, { vehicle: now }),
			/* @__PURE__ */ a(Frames, { id })
		]
	});
}
/** The line that an AGV shares with others; null for a hoist. */
var lineOf = (id) => layout.value?.vehicles.find((one) => one.id === id)?.link ?? null;
var upper = (word) => word === null ? "–" : word.toUpperCase();
var hex = (code) => `0x${code.toString(16).toUpperCase().padStart(4, "0")}`;
function Notes({ vehicle }) {
	return /* @__PURE__ */ a($, { children: [
		vehicle.lockout && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("locked", vehicle.lockout.owner) }),
				" ",
				vehicle.lockout.reason
			]
		}),
		vehicle.hold && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("held_note") }),
				" ",
				tell(vehicle.hold.reason),
				" ",
				/* @__PURE__ */ a("em", { children: tell(vehicle.hold.remedy) })
			]
		}),
		vehicle.waiting && !vehicle.hold && /* @__PURE__ */ a("p", {
			class: "note waits",
			children: [
				/* @__PURE__ */ a("b", { children: t("waits") }),
				" ",
				tell(vehicle.waiting)
			]
		})
	] });
}
function Bits({ vehicle }) {
	return /* @__PURE__ */ a("details", {
		open: true,
		children: [
			/* @__PURE__ */ a("summary", { children: [t(lineOf(vehicle.id) ? "status" : "status_bits"), !lineOf(vehicle.id) && /* @__PURE__ */ a("code", { children: [
				vehicle.status1 ?? "–",
				" ",
				vehicle.status2 ?? ""
			] })] }),
			vehicle.bits.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_status")
			}),
			/* @__PURE__ */ a("table", {
				class: "bits",
				children: /* @__PURE__ */ a("tbody", { children: vehicle.bits.map((bit) => /* @__PURE__ */ a("tr", { children: [
					/* @__PURE__ */ a("th", { children: bit.name }),
					/* @__PURE__ */ a("td", { children: bit.value }),
					/* @__PURE__ */ a("td", { children: bit.meaning })
				] }, bit.name)) })
			})
		]
	});
}
function AgvFacts({ agv }) {
	const word = (name) => said(`agv_${name}`);
	const flag = (on) => t(on ? "yes" : "no");
	return /* @__PURE__ */ a("section", {
		class: "part",
		children: [/* @__PURE__ */ a("h3", { children: t("status") }), /* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("cart"),
				children: word(agv.cart)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("lift"),
				children: word(agv.lift)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("steering"),
				children: word(agv.steering)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("in_position"),
				children: flag(agv.in_position)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("charges_now"),
				children: flag(agv.charging)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("last_tag"),
				children: agv.tag
			}),
			agv.beyond && /* @__PURE__ */ a(Fact, {
				name: t("beyond"),
				children: agv.beyond
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("path"),
				children: agv.path
			})
		] })]
	});
}
function LinkFacts({ vehicle }) {
	const { link } = vehicle;
	const line = lineOf(vehicle.id);
	return /* @__PURE__ */ a("dl", { children: [
		/* @__PURE__ */ a(Fact, {
			name: t("link"),
			children: [/* @__PURE__ */ a("span", {
				class: link.up ? "good" : "bad",
				children: t(link.up ? "link_up" : "link_down", clock(link.since))
			}), !link.up && link.reason && /* @__PURE__ */ a("small", { children: [" · ", tell(link.reason)] })]
		}),
		!line && /* @__PURE__ */ a(Fact, {
			name: t("round_trip"),
			children: link.round_trip_ms === null ? "–" : `${link.round_trip_ms.toFixed(1)} ms`
		}),
		/* @__PURE__ */ a(Fact, {
			name: t("frames_io"),
			children: [
				link.frames_in,
				" / ",
				link.frames_out
			]
		}),
		/* @__PURE__ */ a(Fact, {
			name: t("trouble_counts"),
			children: [
				link.garbled,
				" / ",
				link.resends,
				" / ",
				link.duplicates
			]
		}),
		/* @__PURE__ */ a(Fact, {
			name: t("seen"),
			children: vehicle.seen ? t("ago", span(serverNow() - Date.parse(vehicle.seen))) : "–"
		}),
		line ? /* @__PURE__ */ a(Fact, {
			name: t("on_line"),
			children: t("line_number", line, vehicle.dev_id)
		}) : /* @__PURE__ */ a(Fact, {
			name: t("address"),
			children: [
				vehicle.address,
				" · DEV_ID ",
				vehicle.dev_id,
				" · ",
				vehicle.dialect
			]
		})
	] });
}
function Frames({ id }) {
	const list = useSignal(null);
	const box = T(null);
	A$1(() => {
		let here = true;
		const read = async () => {
			if (box.current?.querySelector("details[open]")) return;
			try {
				const { items } = await get(`/vehicles/${encodeURIComponent(id)}/frames?lang=${language.value}`);
				if (here) list.value = items.slice(-30).reverse();
			} catch {}
		};
		read();
		const timer = window.setInterval(() => void read(), FRAMES_EVERY);
		return () => {
			here = false;
			window.clearInterval(timer);
		};
	}, [id, language.value]);
	return /* @__PURE__ */ a("section", {
		class: "frames",
		ref: box,
		children: [
			/* @__PURE__ */ a("h3", { children: t("last_frames") }),
			list.value?.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_frames")
			}),
			list.value?.map((traffic) => /* @__PURE__ */ a(Frame, { traffic }, `${traffic.at}${traffic.direction}${traffic.hex}`))
		]
	});
}
function Frame({ traffic }) {
	const rows = traffic.frames.flatMap((frame) => frame.fields);
	const main = rows.find((row) => [
		"CMD",
		"MSG",
		"MESSAGE",
		"RESULT"
	].includes(row.name.toUpperCase()));
	const kind = traffic.frames.map((frame) => frame.kind.toUpperCase()).join(" + ");
	return /* @__PURE__ */ a("details", { children: [
		/* @__PURE__ */ a("summary", { children: [
			/* @__PURE__ */ a("span", {
				class: traffic.direction,
				children: traffic.direction === "in" ? "←" : "→"
			}),
			/* @__PURE__ */ a("time", { children: clock(traffic.at) }),
			/* @__PURE__ */ a("b", { children: kind }),
			/* @__PURE__ */ a("span", {
				class: "more",
				children: main ? main.meaning || main.value : ""
			})
		] }),
		/* @__PURE__ */ a("code", {
			class: "hex",
			children: traffic.hex.match(/../g)?.join(" ")
		}),
		/* @__PURE__ */ a("table", {
			class: "bits",
			children: /* @__PURE__ */ a("tbody", { children: rows.map((row, i) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("th", {
					style: { paddingLeft: `${row.depth * .7}em` },
					children: row.name
				}),
				/* @__PURE__ */ a("td", { children: row.value }),
				/* @__PURE__ */ a("td", { children: row.meaning })
			] }, i)) })
		})
	] });
}
var VERDICTS = [
	"go_on",
	"off_rail",
	"stands_at"
];
/** Hold a vehicle; release one that is held or absent. Both want a reason, a release a name as well. */
function Decide({ vehicle }) {
	const reason = useSignal("");
	const verdict = useSignal("go_on");
	const barcode = useSignal(vehicle.barcode ?? "");
	const error = useSignal(null);
	const releasing = vehicle.hold !== null || vehicle.activity === "absent" || vehicle.activity === "off_rail";
	const send = (event) => {
		event.preventDefault();
		error.value = null;
		const path = `/vehicles/${encodeURIComponent(vehicle.id)}/${releasing ? "release" : "hold"}`;
		const stands = verdict.value === "stands_at" ? { barcode: barcode.value.trim() } : {};
		post(path, releasing ? {
			verdict: verdict.value,
			reason: reason.value,
			...stands
		} : { reason: reason.value }).then(() => reason.value = "", (failure) => error.value = failure);
	};
	return /* @__PURE__ */ a("form", {
		class: "decide",
		onSubmit: send,
		children: [
			releasing && /* @__PURE__ */ a("select", {
				"aria-label": t("verdict"),
				value: verdict.value,
				onChange: (event) => verdict.value = event.currentTarget.value,
				children: VERDICTS.map((word) => /* @__PURE__ */ a("option", {
					value: word,
					children: t(`verdict_${word}`)
				}, word))
			}),
			releasing && verdict.value === "stands_at" && /* @__PURE__ */ a("input", {
				"aria-label": t("barcode"),
				required: true,
				value: barcode.value,
				onInput: (event) => barcode.value = event.currentTarget.value
			}),
			/* @__PURE__ */ a("input", {
				"aria-label": t("reason"),
				placeholder: t("reason"),
				required: true,
				maxLength: 200,
				value: reason.value,
				onInput: (event) => reason.value = event.currentTarget.value
			}),
			/* @__PURE__ */ a("button", {
				type: "submit",
				title: releasing && !actor() ? t("your_name") : "",
				children: t(releasing ? "release" : "hold")
			}),
			/* @__PURE__ */ a(Problem, { error: error.value })
		]
	});
}
// src/parts/VehicleStrip.tsx
/** All vehicles at a glance, reachable by key; how many do what where there are too many. */
var CHIPS = 40;
function VehicleStrip() {
	const list = vehicleList.value;
	const pick = selected.value?.kind === "vehicle" ? selected.value.id : "";
	if (list.length > CHIPS) return /* @__PURE__ */ a(Groups, {});
	return /* @__PURE__ */ a("nav", {
		class: "strip",
		"aria-label": t("vehicles"),
		children: list.map((vehicle) => {
			const look = lookOf(vehicle);
			return /* @__PURE__ */ a("button", {
				type: "button",
				class: "chip",
				"aria-pressed": pick === vehicle.id,
				style: { "--look": LOOKS[look] },
				title: tell(vehicle.waiting || vehicle.hold?.reason || ""),
				onClick: () => choose(pick === vehicle.id ? "" : vehicle.id),
				children: [/* @__PURE__ */ a("b", { children: [vehicle.id, vehicle.loaded && /* @__PURE__ */ a("i", { class: "box" })] }), /* @__PURE__ */ a("small", { children: look === "gone" ? t("look_gone") : doing(vehicle) })]
			}, vehicle.id);
		})
	});
}
/** A fleet too large for a chip each: how many look how; the rest is in the room of vehicles. */
function Groups() {
	const counts = /* @__PURE__ */ new Map();
	for (const vehicle of vehicleList.value) counts.set(lookOf(vehicle), (counts.get(lookOf(vehicle)) ?? 0) + 1);
	return /* @__PURE__ */ a("nav", {
		class: "strip",
		"aria-label": t("vehicles"),
		children: Object.keys(LOOKS).map((look) => counts.has(look) && /* @__PURE__ */ a("button", {
			type: "button",
			class: "chip",
			style: { "--look": LOOKS[look] },
			onClick: () => room$1.value = "vehicles",
			children: [/* @__PURE__ */ a("b", { children: counts.get(look) }), /* @__PURE__ */ a("small", { children: t(`look_${look}`) })]
		}, look))
	});
}
function choose(id) {
	selected.value = id ? {
		kind: "vehicle",
		id
	} : null;
}
// src/parts/App.tsx
function App() {
	const pick = selected.value;
	return /* @__PURE__ */ a("div", {
		class: "page",
		children: [
			/* @__PURE__ */ a(Header, {}),
			/* @__PURE__ */ a("main", { children: [/* @__PURE__ */ a("section", {
				class: "left",
				children: room$1.value === "map" ? /* @__PURE__ */ a(Plan, {}) : /* @__PURE__ */ a(Room, {})
			}), /* @__PURE__ */ a("aside", {
				class: pick ? "telling" : "",
				children: [
					/* @__PURE__ */ a(Transfer, {}),
					pick?.kind === "vehicle" && /* @__PURE__ */ a(VehiclePanel, { id: pick.id }, pick.id),
					pick?.kind === "station" && /* @__PURE__ */ a(StationPanel, { id: pick.id }, pick.id),
					pick?.kind === "device" && /* @__PURE__ */ a(DevicePanel, { id: pick.id }, pick.id),
					pick?.kind === "drive" && /* @__PURE__ */ a(DrivePanel, { id: pick.id }, pick.id),
					pick?.kind === "job" && /* @__PURE__ */ a(JobPanel, { id: pick.id }, pick.id),
					/* @__PURE__ */ a(Jobs, {})
				]
			})] }),
			keyWanted.value && /* @__PURE__ */ a(KeyPrompt, {})
		]
	});
}
function Plan() {
	return /* @__PURE__ */ a("div", {
		class: "plan",
		children: [
			/* @__PURE__ */ a(VehicleStrip, {}),
			/* @__PURE__ */ a("div", {
				class: "stage",
				children: [/* @__PURE__ */ a(Circles, {}), /* @__PURE__ */ a(TrackMap, {})]
			}),
			/* @__PURE__ */ a(Below, {})
		]
	});
}
/** Hoists that wait for each other: nothing else matters as much. */
function Circles() {
	const now = controller.value;
	if (!now?.circles?.length) return null;
	return /* @__PURE__ */ a("div", {
		class: "banner",
		role: "alert",
		children: [
			/* @__PURE__ */ a("b", { children: t("circle") }),
			/* @__PURE__ */ a("span", { children: now.circles.map(tell).join(" · ") }),
			/* @__PURE__ */ a("small", {
				class: "calm",
				children: t("circles_counted", now.circles_found, now.circles_resolved)
			})
		]
	});
}
function Room() {
	switch (room$1.value) {
		case "vehicles": return /* @__PURE__ */ a(Vehicles, {});
		case "jobs": return /* @__PURE__ */ a(JobRoom, {});
		case "alarms": return /* @__PURE__ */ a(Alarms, {});
		default: return null;
	}
}
// src/main.tsx
begin();
speak(language.value);
begin$1();
begin$2();
Q(/* @__PURE__ */ a(App, {}), document.getElementById("page"));
